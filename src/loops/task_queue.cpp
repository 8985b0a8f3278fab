// SPDX-License-Identifier: GPL-3.0-or-later
#include "loops/task_queue.hpp"

#include <utility>

namespace tether {

TaskQueue::~TaskQueue() {
  if (!worker_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  given_.notify_one();
  worker_.join();
}

void TaskQueue::start_thread() {
  if (!worker_.joinable()) worker_ = std::thread([this] { work(); });
}

void TaskQueue::rethrow() {
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void TaskQueue::make_room(std::size_t bytes) {
  if (!worker_.joinable()) return;
  std::unique_lock lock(mutex_);
  done_.wait(lock, [&] { return unfinished_ == 0 || (bytes < most_ && held_ <= most_ - bytes); });
  rethrow();
}

void TaskQueue::give(std::function<void()> task, std::size_t bytes) {
  if (!worker_.joinable()) return task();
  make_room(bytes);
  {
    const std::lock_guard lock(mutex_);
    tasks_.push_back({std::move(task), bytes});
    held_ += bytes, ++unfinished_;
  }
  given_.notify_one();
}

/// Works off the tasks. After a task that failed, the others are dropped: they would be done on what it left.
void TaskQueue::work() {
  std::unique_lock lock(mutex_);
  bool failed = false;
  while (true) {
    given_.wait(lock, [&] { return ends_ || !tasks_.empty(); });
    if (tasks_.empty()) return;
    Given next = std::move(tasks_.front());
    tasks_.pop_front();
    lock.unlock();
    std::exception_ptr failure;
    try {
      if (!failed) next.task();
    } catch (...) {
      failure = std::current_exception();
    }
    next.task = nullptr;  // with the memory that it holds
    lock.lock();
    if (failure) failure_ = failure, failed = true;
    held_ -= next.bytes, --unfinished_;
    done_.notify_one();
  }
}

}  // namespace tether
