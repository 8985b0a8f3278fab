// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fem/body_overlaps.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/index.hpp"

namespace tether::fem {

/// "body 2 (region 1)", by the region of the body's first element.
std::string BodyOverlaps::name_of(int part) const {
  const Mesh& mesh = solids_.mesh;
  const std::vector<int> parts = parts_of(mesh);
  std::size_t e = 0;
  while (parts[at(mesh.element(e)[0])] != part) ++e;
  return fmt::format("body {} ({})", part + 1, solids_.regions[at(mesh.region[e])].name);
}

void BodyOverlaps::look(std::span<const double> q, double time, OverlapCount& count,
                        std::vector<std::string>& messages) {
  const Overlap found = finder_.find(q);
  count.now = static_cast<long long>(found.nodes);
  if (count.now > 0 && count.most == 0) {
    const bool own = found.part == found.other;
    const Vector& x = found.place;
    messages.push_back(fmt::format(
        "t = {:.6g}: node {} of {} at ({:.6g}, {:.6g}{}) lies inside {}: nothing stops bodies at one another, what "
        "follows is wrong where they overlap (nodes_inside counts such nodes)",
        time, found.node + 1, name_of(found.part), x[0], x[1],
        solids_.mesh.dim() == 3 ? fmt::format(", {:.6g}", x[2]) : "",
        own ? std::string("that body, which has come through itself") : name_of(found.other)));
  }
  count.most = std::max(count.most, count.now);
}

}  // namespace tether::fem
