// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "grid/jacobian.hpp"
#include "grid/mesh_flaws.hpp"
#include "scene/flow_checks.hpp"
#include "scene/flow_of_deck.hpp"
#include "scene/solids.hpp"

namespace tether {
namespace {

using Place = std::array<double, 2>;

constexpr double tolerance = 1e-9;  // of the mesh's size

Place place_of(const Mesh& mesh, int node) {
  const auto n = 2 * static_cast<std::size_t>(node);
  return {mesh.x[n], mesh.x[n + 1]};
}

double size_of(const Mesh& mesh) {
  const auto [low, high] = std::minmax_element(mesh.x.begin(), mesh.x.end());
  return *high - *low;
}

/// Which places lie within a plane mesh of quadrilaterals, to rounding.
class Inside {
 public:
  explicit Inside(const Mesh& mesh) : mesh_(mesh), within_(tolerance * size_of(mesh)) {}
  bool holds(const Place& p) const {
    for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
      if (near(e, p) && (mesh_.kind == ElementKind::quad4 ? in_element<ShapesOf<ElementKind::quad4>>(e, p)
                                                          : in_element<ShapesOf<ElementKind::quad9>>(e, p)))
        return true;
    }
    return false;
  }

 private:
  /// Whether a place is in the box of an element's nodes, enlarged by what curved edges bulge at most.
  bool near(std::size_t e, const Place& p) const {
    const int* nodes = mesh_.element(e);
    for (std::size_t i = 0; i < 2; ++i) {
      double low = place_of(mesh_, nodes[0])[i], high = low;
      for (int a = 1; a < node_count_of(mesh_.kind); ++a) {
        const double x = place_of(mesh_, nodes[a])[i];
        low = std::min(low, x), high = std::max(high, x);
      }
      const double bulge = within_ + (order_of(mesh_.kind) == 2 ? 0.25 * (high - low) : 0);
      if (p[i] < low - bulge || p[i] > high + bulge) return false;
    }
    return true;
  }
  /// The element's map is turned round by Newton's method; the place is in it where it is the image of one in the
  /// reference element.
  template <class Shapes>
  bool in_element(std::size_t e, const Place& p) const {
    Place s{};
    for (int k = 0; k < 20; ++k) {
      const Place off = offset<Shapes>(e, s, p);
      const auto G = jacobian_at<Shapes>(mesh_, e, s).gradients;  // ds from dx: of s as a field of its own nodes
      const Place step = reference_step<Shapes>(G, off);
      for (std::size_t i = 0; i < 2; ++i) s[i] = std::clamp(s[i] + step[i], -1.5, 1.5);
      if (std::hypot(step[0], step[1]) < 1e-14) break;
    }
    const Place off = offset<Shapes>(e, {std::clamp(s[0], -1.0, 1.0), std::clamp(s[1], -1.0, 1.0)}, p);
    return std::hypot(off[0], off[1]) <= within_;
  }
  /// From the image of s to p.
  template <class Shapes>
  Place offset(std::size_t e, const Place& s, const Place& p) const {
    const auto N = Shapes::values(s);
    Place off = p;
    for (std::size_t a = 0; a < N.size(); ++a) {
      const Place x = place_of(mesh_, mesh_.element(e)[a]);
      off[0] -= N[a] * x[0], off[1] -= N[a] * x[1];
    }
    return off;
  }
  /// ds/dx times a step in x: s is a field whose nodal values are the lattice of the reference element.
  template <class Shapes>
  static Place reference_step(const std::array<double, static_cast<std::size_t>(Shapes::nodes) * 2>& G,
                              const Place& dx) {
    Place step{};
    for (std::size_t a = 0; a < Shapes::nodes; ++a) {
      const double along = G[2 * a] * dx[0] + G[2 * a + 1] * dx[1];
      constexpr std::size_t line = Shapes::line;
      const std::size_t i = a % line, j = a / line;
      step[0] += (2.0 * static_cast<double>(i) / (line - 1) - 1) * along;
      step[1] += (2.0 * static_cast<double>(j) / (line - 1) - 1) * along;
    }
    return step;
  }

  const Mesh& mesh_;
  double within_;  // [length]
};

/// Distance of a place from an element side: the curve through its nodes, in the order of the side.
template <int p>
double distance(const Mesh& mesh, const int* side, const Place& at) {
  double s = 0;
  Place off{};
  for (int k = 0; k < 20; ++k) {
    const auto N = Line<p>::values(s), dN = Line<p>::slopes(s);
    Place along{};
    off = at;
    for (std::size_t a = 0; a < N.size(); ++a) {
      const Place x = place_of(mesh, side[a]);
      for (std::size_t i = 0; i < 2; ++i) off[i] -= N[a] * x[i], along[i] += dN[a] * x[i];
    }
    const double step = (off[0] * along[0] + off[1] * along[1]) / (along[0] * along[0] + along[1] * along[1]);
    const double next = std::clamp(s + step, -1.0, 1.0);
    if (std::abs(next - s) < 1e-15) break;
    s = next;
  }
  return std::hypot(off[0], off[1]);
}

/// The inflow that a place lies on, or null.
const FlowSide* inflow_at(const Flow& flow, const Place& at) {
  const auto per_side = static_cast<std::size_t>(side_node_count_of(flow.mesh.kind));
  const double within = tolerance * size_of(flow.mesh);
  for (const FlowSide& side : flow.sides) {
    for (std::size_t s = 0; s < side.sides.size() && side.boundary == Boundary::inflow; s += per_side) {
      const int* nodes = &side.sides[s];
      const double away =
          flow.mesh.kind == ElementKind::quad4 ? distance<1>(flow.mesh, nodes, at) : distance<2>(flow.mesh, nodes, at);
      if (away <= within) return &side;
    }
  }
  return nullptr;
}

void check_probes(const Deck& deck, const Inside& inside, Diagnostics& diagnostics) {
  for (const Subscript at : deck.given_elements("flow", "probe")) {
    const int k = at[1];
    if (at[0] != 1 || !deck.given("flow", "probe", 2, k)) continue;
    const Place place{deck.real("flow", "probe", 1, k), deck.real("flow", "probe", 2, k)};
    if (inside.holds(place)) continue;
    diagnostics.add(
        deck.remark(Severity::error, "flow", "probe", at,
                    fmt::format("probe {} at ({:.6g}, {:.6g}) lies outside the fluid", k, place[0], place[1]),
                    "a probe records the flow at a place of its mesh, edges included"));
  }
}

/// Of each region the first node that is wrong.
void check_bodies(const Deck& deck, const Solids& solids, const Flow& flow, const Inside& inside,
                  Diagnostics& diagnostics) {
  const std::vector<int> regions = regions_of(deck, false);
  std::set<std::pair<int, int>> seen;
  std::set<int> told;
  for (std::size_t e = 0; e < solids.mesh.element_count(); ++e) {
    const int r = regions[static_cast<std::size_t>(solids.mesh.region[e])];
    for (int a = 0; a < node_count_of(solids.mesh.kind); ++a) {
      const int node = solids.mesh.element(e)[a];
      if (told.contains(r) || !seen.emplace(r, node).second) continue;
      const Place at = place_of(solids.mesh, node);
      const FlowSide* inflow = inflow_at(flow, at);
      if (!inflow && inside.holds(at)) continue;
      told.insert(r);
      const std::string what = inflow ? fmt::format("on the inflow '{}'", inflow->name) : "outside the fluid";
      diagnostics.add(deck.remark(
          Severity::error, "reg", "xvi", {1, r},
          fmt::format("region {}: its node at {} lies {}", r, place_text(solids.mesh, node), what),
          inflow ? "an immersed body goes with the fluid, and there its velocity is prescribed"
                 : "an immersed body lies within the fluid's blocks, which go on beneath it; a hole is outside"));
    }
  }
}

}  // namespace

void check_flow_places(const Deck& deck, const Scene& scene, const Flow& flow, Diagnostics& diagnostics) {
  const Inside inside(flow.mesh);
  check_probes(deck, inside, diagnostics);
  if (scene.solids) check_bodies(deck, *scene.solids, flow, inside, diagnostics);
}

}  // namespace tether
