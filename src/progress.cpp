// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace tether {
namespace {

constexpr double terminal_seconds = 0.1, plain_seconds = 10;  // between lines

}  // namespace

ProgressLine::ProgressLine(std::string name, bool quiet)
    : name_(std::move(name)), quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

void ProgressLine::operator()(const Progress& p) {
  if (!is_due(p.wall_seconds)) return;
  const double done = p.time / p.tmax;
  const double left = done > 0 ? p.wall_seconds * (1 - done) / done : 0;
  const double speed = 1e-6 * static_cast<double>(p.counts.point_steps) / p.wall_seconds;
  show(fmt::format("{}: t {:.5g} of {:.5g}, step {}, dt {:.3g}, {:.2f} M point-steps/s, {:.0f} s left", name_, p.time,
                   p.tmax, p.counts.steps, p.dt, speed, left));
}

void ProgressLine::operator()(const SweepProgress& p) {
  if (!is_due(p.wall_seconds)) return;
  show(fmt::format("{}: {} runs done, {} of them failed, {} left, {:.0f} s left", name_, p.done, p.failed, p.left,
                   p.seconds_left));
}

bool ProgressLine::is_due(double wall_seconds) {
  if (quiet_ || wall_seconds - last_ < (terminal_ ? terminal_seconds : plain_seconds)) return false;
  last_ = wall_seconds;
  return true;
}

void ProgressLine::show(const std::string& line) {
  if (terminal_)
    fmt::print(stderr, "\r\033[K{}", line);
  else
    fmt::print(stderr, "{}\n", line);
  std::fflush(stderr);
  open_ = terminal_;
}

void ProgressLine::clear() {
  if (open_) fmt::print(stderr, "\r\033[K");
  open_ = false;
}

}  // namespace tether
