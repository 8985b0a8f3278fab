// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

namespace tether {

/// Threads that share the loops of a run. Who calls is one of them; the others wait between loops. What a loop
/// computes must not depend on who does which part of it: parts write to places of their own, and what they find is
/// joined in the order of the parts.
class Team {
 public:
  /// So many threads with the caller's, at least 1.
  explicit Team(int threads = 1);
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  int threads() const { return static_cast<int>(others_.size()) + 1; }

  /// Calls body(k) for each k from `begin` to before `end`, each once, by whoever is free, and returns when all are
  /// done. The body throws nothing and calls no loop of the same team.
  template <class Body>
  void each(std::size_t begin, std::size_t end, const Body& body) {
    if (others_.empty() || end < begin + 2) {
      for (std::size_t k = begin; k < end; ++k) body(k);
      return;
    }
    share({[](const void* of, std::size_t k) { (*static_cast<const Body*>(of))(k); }, &body}, begin, end);
  }

 private:
  struct Task {
    void (*part)(const void* body, std::size_t k) = nullptr;
    const void* body = nullptr;
  };

  void share(Task task, std::size_t begin, std::size_t end);
  void work_on_loops();
  bool enter();
  void leave();
  void do_parts();
  void close();

  /// Of the gate: nobody may come in.
  static constexpr std::uint32_t closed = 1U << 31U;

  std::vector<std::thread> others_;
  Task task_;
  std::size_t end_ = 0;
  std::atomic<std::size_t> next_{0};         // part that nobody has taken
  std::atomic<std::uint32_t> loop_{0};       // counts loops; the others wait for the next one
  std::atomic<std::uint32_t> gate_{closed};  // of a loop: how many of the others are in it
  std::atomic<bool> ends_{false};
};

}  // namespace tether
