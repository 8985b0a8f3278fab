// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/edges.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "read/values.hpp"

namespace tether {
namespace {

constexpr std::array<IntegerVariable, 4> wall_names{"in.wl", "in.wr", "in.wb", "in.wt"};
constexpr std::array<AnyVariable, 5> numbers{"mpm.edge_density", "mpm.edge_energy", "mpm.edge_u", "mpm.edge_v",
                                             "mpm.edge_region"};

/// Cells before an open edge in which nothing but gas may stand at the start: there it would share nodes with the
/// strip.
constexpr double clear_cells = 2;

/// One edge's values, with mistakes reported at their places.
class EdgeReader {
 public:
  EdgeReader(const Deck& deck, int k, Diagnostics& diagnostics) : deck_(deck), k_(k), diagnostics_(diagnostics) {}

  Edge read(Wall& wall) const {
    Edge edge;
    edge.kind = word<EdgeKind>(deck_, "mpm.edge", k_);
    if (!edge.open()) {
      for (const AnyVariable name : numbers) tell_idle(name, "edge({0}) is a wall: {1}({0}) has no effect");
      return edge;
    }
    check_wall();
    wall = Wall::open;
    edge.has_outside = given("mpm.edge_density") && given("mpm.edge_energy");
    if (given("mpm.edge_density")) edge.density = deck_.real("mpm.edge_density", k_);
    if (given("mpm.edge_energy")) edge.energy = deck_.real("mpm.edge_energy", k_);
    edge.u = deck_.real("mpm.edge_u", k_), edge.v = deck_.real("mpm.edge_v", k_);
    edge.kind == EdgeKind::inflow ? check_inflow(edge) : check_outflow(edge);
    return edge;
  }

 private:
  bool given(AnyVariable name) const { return deck_.given(name, k_); }
  void add(Severity severity, AnyVariable name, const std::string& what, const std::string& hint) const {
    diagnostics_.add(deck_.remark(severity, name, {k_, 1}, what, hint));
  }
  void tell_idle(AnyVariable name, const char* what) const {
    if (given(name)) add(Severity::warning, name, fmt::format(fmt::runtime(what), k_, name), "leave it out");
  }
  void check_wall() const {
    const IntegerVariable name = wall_names[static_cast<std::size_t>(k_ - 1)];
    if (!deck_.given(name) || static_cast<Wall>(deck_.integer(name)) == Wall::open) return;
    diagnostics_.add(
        deck_.remark(Severity::warning, name, {1, 1},
                     fmt::format("{} = {} gives way to edge({}) of $mpm, an open edge", name, deck_.integer(name), k_),
                     fmt::format("leave {0} out or write {0}=1", name)));
  }
  void check_inflow(const Edge& edge) const {
    for (const AnyVariable name : Variables{"mpm.edge_density", "mpm.edge_energy", across()}) {
      if (given(name)) continue;
      add(Severity::error, "mpm.edge", fmt::format("an inflow needs {}({}), which is not given", name, k_),
          "edge_density, edge_energy and the velocity across the edge are the state of the gas that comes in");
    }
    const double inward = (k_ <= 2 ? edge.u : edge.v) * (k_ % 2 == 1 ? 1 : -1);
    if (inward < 0) {
      add(Severity::error, across(),
          fmt::format("{}({}) points out of the grid, and edge({}) is an inflow", across(), k_, k_),
          "velocities count along +x and +y; gas leaves by an 'outflow'");
    }
  }
  void check_outflow(const Edge& edge) const {
    if (!edge.has_outside && (given("mpm.edge_density") || given("mpm.edge_energy"))) {
      add(Severity::error, given("mpm.edge_density") ? AnyVariable("mpm.edge_density") : "mpm.edge_energy",
          fmt::format("edge({}) is an outflow with half a state outside", k_),
          "give edge_density and edge_energy, or neither");
    }
    for (const AnyVariable name : Variables{"mpm.edge_u", "mpm.edge_v", "mpm.edge_region"})
      tell_idle(name, "edge({0}) is an outflow: {1}({0}) has no effect");
  }
  AnyVariable across() const { return k_ <= 2 ? AnyVariable("mpm.edge_u") : "mpm.edge_v"; }

  const Deck& deck_;
  int k_;  // from 1
  Diagnostics& diagnostics_;
};

/// Distance of a place from edge k, inward.
double inward(const BackgroundGrid& grid, std::size_t k, double x, double y) {
  return k == 0 ? x - grid.x0 : k == 1 ? grid.x1 - x : k == 2 ? y - grid.y0 : grid.y1 - y;
}

/// The gas that has the most points within two cells of edge k; where none has, the scene's only gas.
std::size_t gas_at(const Scene& scene, std::size_t k, bool& found) {
  const double reach = clear_cells * (k < 2 ? scene.grid.dx : scene.grid.dy);
  std::size_t best = 0, most = 0, gases = 0, any = 0;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body& body = scene.bodies[b];
    if (!std::holds_alternative<IdealGas>(body.material)) continue;
    ++gases, any = b;
    std::size_t count = 0;
    for (std::size_t p = body.first; p < body.first + body.count; ++p) {
      if (inward(scene.grid, k, scene.points.x[p], scene.points.y[p]) < reach) ++count;
    }
    if (count > most) most = count, best = b;
  }
  found = most > 0 || gases == 1;
  return most > 0 ? best : any;
}

void choose_gas(const Deck& deck, std::size_t k, Scene& scene, Diagnostics& diagnostics) {
  Edge& edge = scene.edges.of[k];
  const int number = static_cast<int>(k) + 1;
  if (deck.given("mpm.edge_region", number)) {
    const int region = deck.integer("mpm.edge_region", number);
    edge.body = static_cast<std::size_t>(region - 1);
    const bool gas =
        edge.body < scene.bodies.size() && std::holds_alternative<IdealGas>(scene.bodies[edge.body].material);
    if (gas) return;
    diagnostics.add(deck.remark(Severity::error, "mpm.edge_region", {number, 1},
                                fmt::format("region {} is no gas", region), "name the region whose gas comes in"));
    edge.body = 0;
    return;
  }
  bool found = false;
  edge.body = gas_at(scene, k, found);
  if (found) return;
  diagnostics.add(deck.remark(Severity::error, "mpm.edge", {number, 1},
                              fmt::format("no gas stands at the {} edge, and there are several", edge_names[k]),
                              fmt::format("say with edge_region({}) which comes in", number)));
}

/// Solids, membranes and linear fluids must keep off: the strip is of gas alone.
void keep_clear(const Deck& deck, std::size_t k, const Scene& scene, Diagnostics& diagnostics) {
  const double h = k < 2 ? scene.grid.dx : scene.grid.dy;
  for (const Body& body : scene.bodies) {
    if (std::holds_alternative<IdealGas>(body.material)) continue;
    double nearest = scene.grid.x1 - scene.grid.x0 + scene.grid.y1 - scene.grid.y0;
    for (std::size_t p = body.first; p < body.first + body.count; ++p)
      nearest = std::min(nearest, inward(scene.grid, k, scene.points.x[p], scene.points.y[p]));
    if (nearest >= clear_cells * h) continue;
    diagnostics.add(deck.remark(
        Severity::error, "mpm.edge", {static_cast<int>(k) + 1, 1},
        fmt::format("{} is {:.3g} cells from the {} edge, through which only gas passes", body.name,
                    std::max(0.0, nearest / h), edge_names[k]),
        fmt::format("keep solids, membranes and linear fluids at least {} cells off, or make the grid larger",
                    clear_cells)));
  }
}

/// The strip must not reach the axis, let alone lie beyond it.
void check_axis_of(const Deck& deck, const Scene& scene, Diagnostics& diagnostics) {
  const double needed = (strip_cells + 2) * scene.grid.dx;
  if (scene.geometry != Geometry::axisymmetric || !scene.edges.of[0].open() || scene.grid.x0 >= needed) return;
  diagnostics.add(deck.remark(
      Severity::error, "mpm.edge", {1, 1},
      fmt::format("about an axis the left edge at r = {:.6g} cannot be open: {} cells beyond it must lie off the axis",
                  scene.grid.x0, strip_cells + 2),
      fmt::format("xleft must be at least {:.6g}; an edge on the axis has wl=5", needed)));
}

/// Warns of corners where layers of two inflows meet: they come out of step.
void tell_corners(const Deck& deck, const Scene& scene, Diagnostics& diagnostics) {
  const auto enters = [&](std::size_t k) {
    const Edge& edge = scene.edges.of[k];
    return edge.kind == EdgeKind::inflow && (k < 2 ? edge.u : edge.v) != 0;
  };
  for (const std::size_t across : {0U, 1U}) {
    for (const std::size_t up : {2U, 3U}) {
      if (!enters(across) || !enters(up)) continue;
      diagnostics.add(deck.remark(
          Severity::warning, "mpm.edge", {static_cast<int>(up) + 1, 1},
          fmt::format(
              "gas flows in at the {} and at the {} edge: near their corner its density is uneven by {}",
              edge_names[across], edge_names[up],
              scene.method.kernel == Kernel::linear ? "up to a half" : "some per cent, most with few points a cell"),
          "turn the grid so that the stream comes in through one edge"));
      return;
    }
  }
}

}  // namespace

Edges edges_of(const Deck& deck, Walls& walls, Diagnostics& diagnostics) {
  Edges edges;
  const std::array<Wall*, 4> wall{&walls.left, &walls.right, &walls.bottom, &walls.top};
  for (int k = 0; k < 4; ++k) {
    const auto at = static_cast<std::size_t>(k);
    edges.of[at] = EdgeReader(deck, k + 1, diagnostics).read(*wall[at]);
  }
  return edges;
}

void check_edges(const Deck& deck, Scene& scene, Diagnostics& diagnostics) {
  if (!scene.edges.any() || diagnostics.has_errors()) return;
  const bool gas = find_body<IdealGas>(scene) != nullptr;
  for (std::size_t k = 0; k < 4; ++k) {
    if (!scene.edges.of[k].open()) continue;
    if (!gas) {
      diagnostics.add(deck.remark(Severity::error, "mpm.edge", {static_cast<int>(k) + 1, 1},
                                  "an open edge is for gas, and there is none", "leave it out; wl=1 is an open wall"));
      return;
    }
    if (scene.edges.of[k].kind == EdgeKind::inflow) choose_gas(deck, k, scene, diagnostics);
    keep_clear(deck, k, scene, diagnostics);
  }
  check_axis_of(deck, scene, diagnostics);
  tell_corners(deck, scene, diagnostics);
}

}  // namespace tether
