// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/flow.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "base/diagnostics.hpp"

namespace tether {
namespace {

int rank_of(Boundary boundary) {
  return boundary == Boundary::no_slip ? 0 : boundary == Boundary::moving ? 1 : boundary == Boundary::inflow ? 2 : 3;
}

}  // namespace

Vec<2> FlowVector::at(double x, double y, double t) const {
  Vec<2> v{};
  if (absent()) return v;
  const double size = factor.at(t);
  for (std::size_t i = 0; i < 2; ++i) {
    if (!component[i]) continue;
    v[i] = size * (*component[i])(std::array{x, y, t});
    if (!std::isfinite(v[i]))
      throw RunError(
          fmt::format("t = {:.9g}: the expression of {}, '{}', gives {} at ({:.6g}, {:.6g}): likely cause, a division "
                      "by zero or a function outside its range",
                      t, factor.of, component[i]->text(), v[i], x, y));
  }
  return v;
}

double unknowns_of(const Flow& flow) {
  const auto nodes = static_cast<double>(flow.mesh.node_count());
  return flow.element == FlowElement::q1q1 ? 3 * nodes : 2.25 * nodes;
}

bool any_own_volume(const Flow& flow) {
  return std::any_of(flow.volume_by_fluid.begin(), flow.volume_by_fluid.end(), [](bool by_fluid) { return !by_fluid; });
}

std::vector<bool> lighter_regions(const Flow& flow, const Solids& solids) {
  std::vector<bool> lighter;
  for (const SolidRegion& region : solids.regions) lighter.push_back(region.density < flow.density);
  return lighter;
}

Systems systems_of(const Flow& flow, bool with_solids) {
  if (flow.systems != Systems::automatic) return flow.systems;
  const bool suits = flow.integrator != FlowIntegrator::steady && !with_solids;
  return suits && unknowns_of(flow) > most_unknowns_of_factors ? Systems::krylov : Systems::direct;
}

std::vector<Holder> holders_of(const Flow& flow) {
  std::vector<Holder> holders(flow.mesh.node_count());
  for (const int rank : {2, 1, 0}) {
    for (std::size_t s = flow.sides.size(); s-- > 0;) {  // of sides of one kind the first one counts
      if (rank_of(flow.sides[s].boundary) != rank) continue;
      for (const int node : flow.sides[s].sides)
        holders[static_cast<std::size_t>(flow.twin[static_cast<std::size_t>(node)])] = {static_cast<int>(s), node};
    }
  }
  for (std::size_t n = 0; n < holders.size(); ++n) holders[n] = holders[static_cast<std::size_t>(flow.twin[n])];
  return holders;
}

}  // namespace tether
