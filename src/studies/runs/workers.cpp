// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/runs/workers.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "base/child.hpp"
#include "base/diagnostics.hpp"

namespace tether {
namespace {

/// What a pipe takes without anyone reading, on any system: messages are cut to it.
constexpr std::size_t longest_message = 4096;

std::string killed_text(int signal) {
  if (signal == SIGXCPU) return "stopped: it has taken as much of the processor as it may\n";
  return fmt::format("killed by signal {}\n", signal);
}

[[noreturn]] void work_and_exit(pid_t parent, int pipe_end, const std::function<Ending()>& work) {
  if (!end_with_parent(parent)) _exit(exit_signal + SIGKILL);
  const Ending ending = work();
  const std::string text = fmt::format("{}\n{}", ending.failure ? word_of(*ending.failure) : "", ending.message);
  const auto written = write(pipe_end, text.data(), std::min(text.size(), longest_message));
  _exit(written < 0 ? exit_file : ending.exit_code);
}

/// How a process ended that says so through its pipe: the failure in the first line, then the message.
Ending read_ending(int pipe_end, int exit_code) {
  std::array<char, longest_message> chars{};
  const auto length = read(pipe_end, chars.data(), chars.size());
  const std::string text(chars.data(), static_cast<std::size_t>(std::max(length, ssize_t{0})));
  const auto end = text.find('\n');
  if (end == std::string::npos) return {exit_code, text};
  return {exit_code, text.substr(end + 1), find_word<Failure>(text.substr(0, end))};
}

}  // namespace

void Workers::drop_all() {
  tell(SIGKILL);
  for (const auto& [id, process] : running_) {
    waitpid(process.pid, nullptr, 0);
    close(process.message);
  }
  running_.clear();
}

void Workers::start(std::size_t id, const std::function<Ending()>& work) {
  std::array<int, 2> ends{};
  const pid_t parent = getpid();
  if (pipe(ends.data()) != 0) throw FileError(fmt::format("no process can be started: {}", std::strerror(errno)));
  const auto start = std::chrono::steady_clock::now();
  const pid_t pid = fork();
  if (pid == 0) work_and_exit(parent, ends[1], work);
  const int reason = errno;
  close(ends[1]);
  if (pid > 0) {
    running_[id] = {pid, ends[0], start};
    return;
  }
  close(ends[0]);
  throw FileError(fmt::format("no process can be started: {}", std::strerror(reason)));
}

std::optional<Finished> Workers::take() {
  for (const auto& [id, process] : running_) {
    int status = 0;
    rusage usage{};
    if (wait4(process.pid, &status, WNOHANG, &usage) != process.pid) continue;
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - process.start;
    Finished finished{id, {}, processor_seconds(usage), wall.count()};
    if (WIFSIGNALED(status))
      finished.ending = {exit_signal + WTERMSIG(status), killed_text(WTERMSIG(status))};
    else
      finished.ending = read_ending(process.message, WEXITSTATUS(status));
    close(process.message);
    running_.erase(id);
    return finished;
  }
  return std::nullopt;
}

void Workers::tell(int signal) const {
  for (const auto& [id, process] : running_) {
    kill(process.pid, signal);
    kill(process.pid, SIGCONT);  // one that was stopped hears nothing
  }
}

}  // namespace tether
