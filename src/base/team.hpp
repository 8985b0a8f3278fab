// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace tether {

/// Who shares the loops of a run: here the caller alone; others join it where a run has threads (ThreadTeam). What a
/// loop computes must not depend on who does which part of it: parts write to places of their own, and what they find
/// is joined in the order of the parts.
class Team {
 public:
  Team() = default;
  virtual ~Team() = default;
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  /// Counts the threads with the caller's: at least 1.
  int threads() const { return others_ + 1; }

  /// Calls body(k) for each k from `begin` to before `end`, each once, by whoever is free, and returns when all are
  /// done. The body throws nothing and calls no loop of the same team.
  template <class Body>
  void each(std::size_t begin, std::size_t end, const Body& body) {
    if (others_ == 0 || end < begin + 2) {
      for (std::size_t k = begin; k < end; ++k) body(k);
      return;
    }
    share({[](const void* of, std::size_t k) { (*static_cast<const Body*>(of))(k); }, &body}, begin, end);
  }

 protected:
  /// One part of a loop, whatever its body is.
  struct Task {
    void operator()(std::size_t k) const { part(body, k); }
    void (*part)(const void* body, std::size_t k) = nullptr;
    const void* body = nullptr;
  };

  explicit Team(int others) : others_(others) {}

  /// Does all parts of a loop: called once a loop.
  virtual void share(Task task, std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) task(k);
  }

 private:
  int others_ = 0;
};

}  // namespace tether
