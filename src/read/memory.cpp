// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/memory.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <limits>

#include "model/size.hpp"

namespace tether {
namespace {

/// Part of the memory that a run may take.
constexpr double usable = 0.8;

/// Of the machine, or what the shell allows this process where that is less.
double memory_there() {
  const double physical = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return physical;
  return std::min(physical, static_cast<double>(limit.rlim_cur));
}

}  // namespace

std::string memory_refusal(const BackgroundGrid& grid, double points) {
  const double nodes = static_cast<double>(grid.nx) * static_cast<double>(grid.ny);
  const double bytes = nodes * bytes_per_node + points * bytes_per_point;
  const double there = usable * memory_there();
  const double most = std::numeric_limits<int>::max();
  if (bytes <= there && nodes <= most && points <= most) return "";
  return fmt::format("{} x {} nodes and {:.3g} points would need {:.4g} GB of memory, and {:.4g} GB can be used",
                     grid.nx, grid.ny, points, 1e-9 * bytes, 1e-9 * there);
}

std::string memory_refusal(const StaggeredGrid& grid) {
  const double cells = static_cast<double>(grid.n[0]) * static_cast<double>(grid.n[1]) * static_cast<double>(grid.n[2]);
  const double bytes = cells * bytes_per_cell, there = usable * memory_there();
  if (bytes <= there && 4 * cells <= std::numeric_limits<int>::max()) return "";
  return fmt::format("{} x {} x {} cells would need {:.4g} GB of memory, and {:.4g} GB can be used", grid.n[0],
                     grid.n[1], grid.n[2], 1e-9 * bytes, 1e-9 * there);
}

}  // namespace tether
