// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <utility>

namespace tether {

/// Numbers on their way from one thread to another, which takes them in the order in which they come.
class Channel {
 public:
  using Numbers = std::unique_ptr<double[]>;

  /// So many at most wait to be taken.
  explicit Channel(std::size_t most) : most_(most) {}

  /// Waits while there are too many, unless nobody takes them any more: then they are let go.
  void put(Numbers numbers) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return closed_ || waiting_.size() < most_; });
    if (!closed_) waiting_.push_back(std::move(numbers));
    changed_.notify_all();
  }
  /// Waits until there are some.
  Numbers take() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !waiting_.empty(); });
    Numbers numbers = std::move(waiting_.front());
    waiting_.pop_front();
    changed_.notify_all();
    return numbers;
  }
  /// Nobody takes any more.
  void close() {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    waiting_.clear();
    changed_.notify_all();
  }

 private:
  const std::size_t most_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Numbers> waiting_;
  bool closed_ = false;
};

}  // namespace tether
