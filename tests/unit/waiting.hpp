// SPDX-License-Identifier: GPL-3.0-or-later
// Waits for what is to be seen: tests neither sleep nor look at a clock anywhere else.
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

namespace tether::test {

/// Returns whether a condition comes to hold before nobody would wait any longer, however busy the machine is.
template <typename Condition>
bool wait_until(const Condition& holds) {
  constexpr std::chrono::minutes patience(5);
  const auto end = std::chrono::steady_clock::now() + patience;
  while (!holds()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

/// Returns whether a thread of this process sleeps, by what the kernel says of it: "TID (NAME) STATE ...".
inline bool sleeps(const std::filesystem::path& thread) {
  std::ifstream file(thread / "stat");
  std::string text;
  std::getline(file, text);
  return text.find(") S ") != std::string::npos;
}

/// Returns how many threads of this process sleep.
inline int sleeping_threads() {
  int count = 0;
  for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task")) count += sleeps(thread.path());
  return count;
}

/// Returns the folder in which the kernel describes the thread that calls.
inline std::filesystem::path this_thread() { return fmt::format("/proc/self/task/{}", ::gettid()); }

}  // namespace tether::test
