// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/process.hpp"

#include <fmt/format.h>
#include <malloc.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <fstream>
#include <new>
#include <system_error>

#include "base/child.hpp"
#include "base/diagnostics.hpp"
#include "base/text.hpp"

namespace tether {

Seconds seconds_now() {
  timespec cpu{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &cpu);
  rusage children{};
  getrusage(RUSAGE_CHILDREN, &children);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now().time_since_epoch();
  return {static_cast<double>(cpu.tv_sec) + 1e-9 * static_cast<double>(cpu.tv_nsec) + processor_seconds(children),
          wall.count()};
}

Ending end_of(const std::string& name, const std::function<void()>& work) {
  const auto told = [&name](const char* what) { return with_short_words(fmt::format("{}: error: {}\n", name, what)); };
  try {
    work();
    return {};
  } catch (const InputError& error) {
    const bool names_its_file = !error.diagnostics().front().place.file.empty();
    return {exit_input, (names_its_file ? "" : name + ": ") + error.what()};
  } catch (const std::bad_alloc&) {
    return {exit_input, told("it needs more memory than there is")};
  } catch (const RunError& error) {
    return {exit_run, told(error.what()), error.failure()};
  } catch (const FileError& error) {
    return {exit_file, told(error.what())};
  } catch (const std::system_error& error) {  // as of a terminal or a pipe that takes no more text
    return {exit_file, told(error.what())};
  } catch (const Interrupted& interrupted) {
    return {exit_signal + interrupted.signal(), fmt::format("{}: {}\n", name, interrupted.what())};
  }
}

SignalWatch::SignalWatch(std::initializer_list<int> signals) : watched_{}, before_{} {
  sigemptyset(&watched_);
  for (const int signal : signals) sigaddset(&watched_, signal);
  sigprocmask(SIG_BLOCK, &watched_, &before_);
}

SignalWatch::~SignalWatch() { sigprocmask(SIG_SETMASK, &before_, nullptr); }

int SignalWatch::wait(double seconds, int file) {
  if (file >= 0) {  // a signal that is held back can be read from a file of its own
    const int signals = signalfd(-1, &watched_, SFD_CLOEXEC);
    std::array<pollfd, 2> both{{{file, POLLIN, 0}, {signals, POLLIN, 0}}};
    poll(both.data(), both.size(), static_cast<int>(1000 * seconds));
    close(signals);
    return take();
  }
  const double whole = std::floor(seconds);
  const timespec patience{static_cast<time_t>(whole), static_cast<long>(1e9 * (seconds - whole))};
  return std::max(sigtimedwait(&watched_, nullptr, &patience), 0);
}

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "an unknown host";
}

void keep_freed_memory() {
  mallopt(M_MMAP_MAX, 0);         // nothing has a mapping of its own, which would go with it
  mallopt(M_TRIM_THRESHOLD, -1);  // and the heap does not shrink
}

double peak_memory_mb() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kilobytes = 0;
    if (word == "VmHWM:" && status >> kilobytes) return 1e-3 * kilobytes;
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1e-3 * static_cast<double>(usage.ru_maxrss);
}

}  // namespace tether
