// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/compare.hpp"

#include <fmt/format.h>
#include <stdexcept>

namespace tether {

Merit relative_merit(FigureName name, double here, double exact) {
  return {name.text(), here, exact, (here - exact) / exact, false};
}

const std::vector<double>& values_of(const Snapshot& snapshot, const std::string& name) {
  for (const Field& field : snapshot.fields) {
    if (field.quantity.name == name) return field.values;
  }
  throw std::out_of_range("the snapshot has no field " + name);
}

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
    case ReferenceKind::radial_gas:
      return compare_radial_gas(scene, last_points);
    case ReferenceKind::thin_ring:
      return compare_thin_ring(scene, last_points);
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
  if (comparison.window) {
    summary.push_back(line_of("compared_from", comparison.window->front()));
    summary.push_back(line_of("compared_to", comparison.window->back()));
  }
  return summary;
}

}  // namespace tether
