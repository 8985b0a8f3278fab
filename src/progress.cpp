// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>

namespace tether {
namespace {

constexpr double terminal_seconds = 0.1, plain_seconds = 10;  // between lines

/// Returns the width of the terminal, which may change; one less, so that the cursor stays in the line.
std::size_t terminal_width() {
  constexpr std::size_t usual = 80;
  winsize size{};
  const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
  return (known ? size.ws_col : usual) - 1;
}

}  // namespace

ProgressLine::ProgressLine(const std::string& deck, bool quiet)
    : name_(std::filesystem::path(deck).filename().string()), quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

std::string fitting(const std::vector<std::string>& parts, std::size_t width) {
  std::string line = parts.front();
  for (std::size_t k = 1; k < parts.size() && line.size() + 2 + parts[k].size() <= width; ++k) line += ", " + parts[k];
  return line.substr(0, width);
}

void ProgressLine::operator()(const Progress& p) {
  if (!is_due(p.wall_seconds)) return;
  const double done = p.time / p.tmax;
  const double left = done > 0 ? p.wall_seconds * (1 - done) / done : 0;
  show({fmt::format("{}: t {:.5g} of {:.5g}", name_, p.time, p.tmax), fmt::format("{:.0f} s left", left),
        fmt::format("step {}", p.counts.steps), fmt::format("dt {:.3g}", p.dt),
        fmt::format("{:.3g} steps/s", static_cast<double>(p.counts.steps) / p.wall_seconds)});
}

void ProgressLine::operator()(const SweepProgress& p) {
  if (!is_due(p.wall_seconds)) return;
  show({fmt::format("{}: {} runs done", name_, p.done), fmt::format("{} of them failed", p.failed),
        fmt::format("{} left", p.left), fmt::format("{:.0f} s left", p.seconds_left)});
}

bool ProgressLine::is_due(double wall_seconds) {
  if (quiet_ || wall_seconds - last_ < (terminal_ ? terminal_seconds : plain_seconds)) return false;
  last_ = wall_seconds;
  return true;
}

void ProgressLine::show(const std::vector<std::string>& parts) {
  if (terminal_)
    fmt::print(stderr, "\r\033[K{}", fitting(parts, terminal_width()));
  else
    fmt::print(stderr, "{}\n", fmt::join(parts, ", "));
  std::fflush(stderr);
  open_ = terminal_;
}

void ProgressLine::clear() {
  if (open_) fmt::print(stderr, "\r\033[K");
  open_ = false;
}

}  // namespace tether
