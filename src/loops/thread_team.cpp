// SPDX-License-Identifier: GPL-3.0-or-later
#include "loops/thread_team.hpp"

#include <algorithm>

namespace tether {
namespace {

/// Looks at a number for about as long as a short loop takes before the thread goes to sleep: to wake one costs more.
constexpr int looks = 4000;

inline void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

/// Returns once `value` is no longer `old`.
void wait_for_change(const std::atomic<std::uint32_t>& value, std::uint32_t old) {
  for (int look = 0; look < looks; ++look) {
    if (value.load(std::memory_order_acquire) != old) return;
    pause();
  }
  while (value.load(std::memory_order_acquire) == old) value.wait(old, std::memory_order_acquire);
}

}  // namespace

ThreadTeam::ThreadTeam(int threads) : Team(std::max(0, threads - 1)) {
  for (int t = 1; t < threads; ++t) others_.emplace_back([this] { work_on_loops(); });
}

ThreadTeam::~ThreadTeam() {
  ends_ = true;
  loop_.fetch_add(1, std::memory_order_release);
  loop_.notify_all();
  for (std::thread& other : others_) other.join();
}

/// Does not wait for threads that have not woken by the time all parts are taken.
void ThreadTeam::share(Task task, std::size_t begin, std::size_t end) {
  task_ = task, end_ = end;
  next_.store(begin, std::memory_order_relaxed);
  gate_.store(0, std::memory_order_release);
  loop_.fetch_add(1, std::memory_order_release);
  loop_.notify_all();
  do_parts();
  close();
}

void ThreadTeam::do_parts() {
  for (std::size_t k = next_.fetch_add(1, std::memory_order_relaxed); k < end_;
       k = next_.fetch_add(1, std::memory_order_relaxed))
    task_(k);
}

/// Once nobody is in the loop any more.
void ThreadTeam::close() {
  std::uint32_t inside = 0;
  while (!gate_.compare_exchange_strong(inside, closed, std::memory_order_acq_rel)) {
    wait_for_change(gate_, inside);
    inside = 0;
  }
}

bool ThreadTeam::enter() {
  std::uint32_t inside = gate_.load(std::memory_order_acquire);
  while ((inside & closed) == 0) {
    if (gate_.compare_exchange_weak(inside, inside + 1, std::memory_order_acq_rel)) return true;
  }
  return false;
}

void ThreadTeam::leave() {
  if (gate_.fetch_sub(1, std::memory_order_acq_rel) == 1) gate_.notify_one();
}

void ThreadTeam::work_on_loops() {
  for (std::uint32_t seen = 0;;) {
    wait_for_change(loop_, seen);
    if (ends_) return;
    seen = loop_.load(std::memory_order_acquire);
    if (!enter()) continue;
    do_parts();
    leave();
  }
}

}  // namespace tether
