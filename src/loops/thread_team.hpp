// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

#include "base/team.hpp"

namespace tether {

/// Threads that share the loops of a run. Who calls is one of them; the others wait between loops.
class ThreadTeam final : public Team {
 public:
  /// So many threads with the caller's, at least 1.
  explicit ThreadTeam(int threads);
  ~ThreadTeam() override;

 private:
  void share(Task task, std::size_t begin, std::size_t end) override;
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
