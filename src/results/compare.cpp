// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/compare.hpp"

#include <fmt/format.h>

#include "results/compare_parts.hpp"

namespace tether {

Comparison compare(const Scene& scene, const History& history, const Snapshot& last_points) {
  switch (scene.reference) {
    case ReferenceKind::riemann:
      return compare_riemann(scene, last_points);
    case ReferenceKind::spring:
      return compare_spring(scene, history);
    case ReferenceKind::string:
      return compare_string(scene, history);
    case ReferenceKind::pendulum:
      return compare_pendulum(scene, history);
    case ReferenceKind::piston:
      return compare_piston(scene, history);
    case ReferenceKind::none:
      break;
  }
  return {};
}

Summary summary_of(const Comparison& comparison) {
  Summary summary;
  for (const Merit& merit : comparison.merits) {
    if (!merit.profile) {
      summary.emplace_back(merit.name, fmt::format("{}", merit.here));
      summary.emplace_back("exact_" + merit.name, fmt::format("{}", merit.exact));
    }
    summary.emplace_back("error_" + merit.name, fmt::format("{}", merit.error));
  }
  return summary;
}

}  // namespace tether
