// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/workers.hpp"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "base/errors.hpp"

namespace tether {
namespace {

/// What a pipe takes without anyone reading, on any system: messages are cut to it.
constexpr std::size_t longest_message = 4096;

[[noreturn]] void work_and_exit(pid_t parent, int pipe_end, const std::function<Ending()>& work) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(exit_signal + SIGKILL);  // it died before it could be watched
  const Ending ending = work();
  const auto written = write(pipe_end, ending.message.data(), std::min(ending.message.size(), longest_message));
  _exit(written < 0 ? exit_file : ending.exit_code);
}

std::string read_message(int pipe_end) {
  std::array<char, longest_message> text{};
  const auto length = read(pipe_end, text.data(), text.size());
  return {text.data(), static_cast<std::size_t>(std::max(length, ssize_t{0}))};
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

Workers::~Workers() {
  tell(SIGKILL);
  for (const auto& [id, process] : running_) {
    waitpid(process.pid, nullptr, 0);
    close(process.message);
  }
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
    Finished finished{id, {}, seconds(usage.ru_utime) + seconds(usage.ru_stime), wall.count()};
    if (WIFSIGNALED(status))
      finished.ending = {exit_signal + WTERMSIG(status), fmt::format("killed by signal {}\n", WTERMSIG(status))};
    else
      finished.ending = {WEXITSTATUS(status), read_message(process.message)};
    close(process.message);
    running_.erase(id);
    return finished;
  }
  return std::nullopt;
}

void Workers::tell(int signal) const {
  for (const auto& [id, process] : running_) kill(process.pid, signal);
}

}  // namespace tether
