// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "base/diagnostics.hpp"

namespace tether {
namespace {

constexpr int failed = 1;

[[noreturn]] void work_and_exit(pid_t parent, int end, const std::function<std::string()>& work) {
  if (!end_with_parent(parent)) _exit(failed);
  const int nowhere = open("/dev/null", O_WRONLY);
  if (nowhere < 0 || dup2(nowhere, STDOUT_FILENO) < 0 || dup2(nowhere, STDERR_FILENO) < 0) _exit(failed);
  try {
    const std::string bytes = work();
    for (std::size_t sent = 0; sent < bytes.size();) {
      const ssize_t count = write(end, bytes.data() + sent, bytes.size() - sent);
      if (count < 0 && errno != EINTR) _exit(failed);
      sent += count > 0 ? static_cast<std::size_t>(count) : 0;
    }
  } catch (...) {
    _exit(failed);
  }
  _exit(0);
}

std::string all_from(int end) {
  std::string bytes;
  std::array<char, 65536> part{};
  while (true) {
    const ssize_t count = read(end, part.data(), part.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return bytes;
    bytes.append(part.data(), static_cast<std::size_t>(count));
  }
}

/// Waits for its end.
int status_of(pid_t pid) {
  int status = 0;
  while (waitpid(pid, &status, 0) < 0 && errno == EINTR) continue;
  return status;
}

}  // namespace

double processor_seconds(const rusage& usage) noexcept {
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

bool end_with_parent(pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  return getppid() == parent;  // else it died before it could be watched
}

std::optional<std::string> from_a_child(const std::function<std::string()>& work) {
  std::array<int, 2> ends{};
  const pid_t parent = getpid();
  const auto refuse = [] { throw RunError(fmt::format("no process can be started: {}", std::strerror(errno))); };
  if (pipe(ends.data()) != 0) refuse();
  const pid_t pid = fork();
  if (pid == 0) close(ends[0]), work_and_exit(parent, ends[1], work);
  close(ends[1]);
  if (pid < 0) close(ends[0]), refuse();
  std::string bytes = all_from(ends[0]);
  close(ends[0]);
  const int status = status_of(pid);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return std::nullopt;
  return bytes;
}

std::pair<int, std::string> said_by(std::vector<std::string> words) {
  std::array<int, 2> ends{};
  const pid_t pid = pipe(ends.data()) == 0 ? fork() : -1;
  if (pid < 0) throw FileError(fmt::format("{}: cannot be started: {}", words.front(), std::strerror(errno)));
  if (pid == 0) {
    dup2(ends[1], STDOUT_FILENO), dup2(ends[1], STDERR_FILENO), close(ends[0]), close(ends[1]);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execvp(arguments.front(), arguments.data());
    _exit(127);
  }
  close(ends[1]);
  std::string said = all_from(ends[0]);
  close(ends[0]);
  const int status = status_of(pid);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, std::move(said)};
}

}  // namespace tether
