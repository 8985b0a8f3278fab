// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace tether {

/// Tasks that are done one after the other in the order in which they are given: at once by who gives them or, once
/// there is a thread for them, by this one while the giver goes on. What a task throws, the next call throws, and no
/// task after it is done.
class TaskQueue {
 public:
  /// Tasks that wait hold no more memory than this, but for a single one that needs more [bytes].
  explicit TaskQueue(std::size_t most) : most_(most) {}
  /// After all that has been given.
  ~TaskQueue();
  TaskQueue(const TaskQueue&) = delete;
  TaskQueue& operator=(const TaskQueue&) = delete;

  /// From now on tasks have a thread of their own.
  void start_thread();
  bool has_thread() const { return worker_.joinable(); }
  /// Waits until there is room for so many bytes.
  void make_room(std::size_t bytes);
  /// A task that holds so many bytes, once there is room for them.
  void give(std::function<void()> task, std::size_t bytes);
  /// Until all that has been given is done.
  void wait() { make_room(most_); }

 private:
  struct Given {
    std::function<void()> task;
    std::size_t bytes = 0;
  };
  void work();
  void rethrow();

  const std::size_t most_;
  std::mutex mutex_;
  std::condition_variable given_, done_;
  std::deque<Given> tasks_;
  std::size_t held_ = 0;        // bytes, of the task that is being done, too
  std::size_t unfinished_ = 0;  // tasks
  bool ends_ = false;
  std::exception_ptr failure_;
  std::thread worker_;
};

}  // namespace tether
