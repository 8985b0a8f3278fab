// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "loops/points.hpp"
#include "physics/points/strips.hpp"

namespace tether::mpm {

// The points of the strips: how they are laid at the start, made at the far end, and taken out of the arrays.

namespace {

constexpr double length_cells = strip_cells;

}  // namespace

/// At the start: the lattice goes on beyond the edge, with the density of the gas there or of what comes in.
void Strips::fill(const BodyPoints& bodies, const Scene& scene) {
  if (!on_) return;
  gone_.assign(bodies.points.size(), 0);
  for (std::size_t k = 0; k < 4; ++k) {
    if (!edges_.of[k].open()) continue;
    find_bodies_at(k, bodies, scene);
    lay_rows(k, scene);
    for (std::size_t row = 0; row < rows_[k].place.size(); ++row) fill_row(k, row, bodies, scene);
    if (k < 2) fill_corners(k, bodies, scene);
  }
  regroup(bodies, scene);
}

/// Once the points have densities and energies.
StepFindings Strips::begin(const BodyPoints& bodies, const Scene& scene) {
  if (!on_) return {};
  look_inside(bodies, scene);
  return set_strips(bodies, scene);
}

/// The gas with the most mass in the cell before the edge, or none.
void Strips::find_bodies_at(std::size_t k, const BodyPoints& bodies, const Scene& scene) {
  const Points& P = bodies.points;
  const auto n = static_cast<std::size_t>(cells_along(k));
  Cells& cells = cells_[k];
  cells.body.assign(n, -1);
  for (auto* array : {&cells.density, &cells.across, &cells.along, &cells.pressure}) array->assign(n, 0.0);
  cells.on_edge.assign(n, {});
  std::vector<double> most(n, 0.0);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (!std::holds_alternative<IdealGas>(scene.bodies[b].material)) continue;
    std::vector<double> mass(n, 0.0);
    for_points(bodies.ranges[b].full(), [&](std::size_t p) {
      const double distance = inward(k, P.x[p], P.y[p]);
      if (distance < cell_across(k) && !holds(P.x[p], P.y[p])) mass[cell_of(k, k < 2 ? P.y[p] : P.x[p])] += P.mass[p];
    });
    for (std::size_t c = 0; c < n; ++c) {
      if (mass[c] > most[c]) most[c] = mass[c], cells.body[c] = static_cast<int>(b);
    }
  }
}

/// The lattice of the gas that comes in, or of that at the edge.
void Strips::lay_rows(std::size_t k, const Scene& scene) {
  Rows& rows = rows_[k];
  const Edge& edge = edges_.of[k];
  for (int c = 0; c < cells_along(k); ++c) {
    const int body = cells_[k].body[static_cast<std::size_t>(c)];
    const Body& of = edge.kind == EdgeKind::inflow ? scene.bodies[edge.body]
                     : body >= 0                   ? scene.bodies[static_cast<std::size_t>(body)]
                                                   : *find_body<IdealGas>(scene);
    for (int a = 0; a < of.lattice; ++a) {
      rows.place.push_back(first_along(k) + (c + (a + 0.5) / of.lattice) * cell_along(k));
      rows.cell.push_back(c), rows.lattice.push_back(of.lattice);
      rows.tail.push_back((0.5 / of.lattice - length_cells) * cell_across(k));
    }
  }
}

void Strips::fill_row(std::size_t k, std::size_t row, const BodyPoints& bodies, const Scene& scene) {
  const Rows& rows = rows_[k];
  const Edge& edge = edges_.of[k];
  const int there = cells_[k].body[static_cast<std::size_t>(rows.cell[row])];
  if (edge.kind == EdgeKind::outflow && there < 0) return;
  const std::size_t body = edge.kind == EdgeKind::inflow ? edge.body : static_cast<std::size_t>(there);
  const double density = edge.kind == EdgeKind::inflow ? edge.density : scene.bodies[body].density;
  const double spacing = cell_across(k) / rows.lattice[row], area = spacing * cell_along(k) / rows.lattice[row];
  for (int a = 0; a < strip_cells * rows.lattice[row]; ++a) {
    const double place = low(k) ? line(k) - (a + 0.5) * spacing : line(k) + (a + 0.5) * spacing;
    make(bodies, scene, body, k < 2 ? place : rows.place[row], k < 2 ? rows.place[row] : place, density, area);
  }
}

/// The block where the strips of two open edges meet: it gives the corner's nodes their mass, and stays.
void Strips::fill_corners(std::size_t k, const BodyPoints& bodies, const Scene& scene) {
  for (const std::size_t other : {std::size_t{2}, std::size_t{3}}) {
    if (!edges_.of[other].open()) continue;
    const std::size_t cell = other == 2 ? 0 : cells_[k].body.size() - 1;
    const Edge& edge = edges_.of[k];
    const int there = cells_[k].body[cell];
    if (edge.kind == EdgeKind::outflow && there < 0) continue;
    const std::size_t body = edge.kind == EdgeKind::inflow ? edge.body : static_cast<std::size_t>(there);
    const double density = edge.kind == EdgeKind::inflow ? edge.density : scene.bodies[body].density;
    const int side = scene.bodies[body].lattice, n = strip_cells * side;
    const double dx = grid_.dx / side, dy = grid_.dy / side;
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const double x = (i + 0.5) * dx, y = (j + 0.5) * dy;
        make(bodies, scene, body, low(k) ? line(k) - x : line(k) + x, other == 2 ? line(other) - y : line(other) + y,
             density, dx * dy);
      }
    }
  }
}

/// A point after all others, for regroup() to take to its body. Beyond an edge of constant radius it has the mass that
/// it would have on the edge, since as it moves the ring's width does not change.
void Strips::make(const BodyPoints& bodies, const Scene& scene, std::size_t body, double x, double y, double density,
                  double area) {
  Points& P = bodies.points;
  P.each_array([](auto& array) { array.push_back(0); });
  const double radius = std::clamp(x, grid_.x0, grid_.x1);
  P.x.back() = x, P.y.back() = y, P.rho.back() = density;
  P.volume.back() = area * depth(scene.geometry, radius), P.mass.back() = density * P.volume.back();
  P.id.back() = next_id_++;
  made_.push_back(static_cast<int>(body));
}

/// The lattice moves with the gas on the edge; whole spacings are made as it moves in, and forgotten as it moves out.
void Strips::feed(std::size_t k, const BodyPoints& bodies, const Scene& scene, double dt) {
  Rows& rows = rows_[k];
  const double h = cell_across(k), end = -length_cells * h;
  for (std::size_t row = 0; row < rows.place.size(); ++row) {
    const EdgeGas gas = on_edge(k, rows.place[row]);
    const double spacing = h / rows.lattice[row], area = spacing * cell_along(k) / rows.lattice[row];
    const Edge& edge = edges_.of[k];
    const int there = cells_[k].body[static_cast<std::size_t>(rows.cell[row])];
    const int body = edge.kind == EdgeKind::inflow ? static_cast<int>(edge.body) : there;
    double& tail = rows.tail[row];
    tail += dt * gas.across;
    while (tail < end - 1e-9 * h) tail += spacing;
    for (; tail - spacing >= end; tail -= spacing) {
      if (body < 0 || !(gas.density > 0)) continue;
      const double inner = tail - spacing, place = low(k) ? line(k) + inner : line(k) - inner;
      make(bodies, scene, static_cast<std::size_t>(body), k < 2 ? place : rows.place[row],
           k < 2 ? rows.place[row] : place, gas.density, area);
    }
  }
}

/// Takes out what is gone and brings what was made to its body. Bodies other than gas come first, so that their slots
/// never change while the scene runs.
void Strips::regroup(const BodyPoints& bodies, const Scene& scene) {
  Points& P = bodies.points;
  const std::size_t before = P.size() - made_.size();
  order_.clear();
  for (const bool gas : {false, true}) {
    for (std::size_t b = 0; b < bodies.ranges.size(); ++b) {
      if (std::holds_alternative<IdealGas>(scene.bodies[b].material) != gas) continue;
      const std::size_t begin = order_.size();
      for_points(bodies.ranges[b].full(), [&](std::size_t p) {
        if (!gone_[p]) order_.push_back(p);
      });
      for (std::size_t n = 0; n < made_.size(); ++n) {
        if (made_[n] == static_cast<int>(b)) order_.push_back(before + n);
      }
      bodies.ranges[b] = {begin, order_.size()};
    }
  }
  P.each_array([&](auto& array) {
    doubles_.clear();
    for (const std::size_t p : order_) doubles_.push_back(static_cast<double>(array[p]));
    array.resize(order_.size());
    std::transform(doubles_.begin(), doubles_.end(), array.begin(),
                   [](double value) { return static_cast<typename std::decay_t<decltype(array)>::value_type>(value); });
  });
  made_.clear();
}

// The gas on open edges: what is seen inside, what the Riemann problem with the outside makes of it, and the points of
// the strips that carry it.

namespace {

/// Cells before an edge over which the gas inside is averaged.
constexpr double seen_cells = 2;
/// Cells of a strip that reach the points inside; those further out may lack mass, and their density is the edge's.
constexpr double whole_cells = 3;

}  // namespace

/// Means over the gas within two cells of the edge, for each cell along it: density by volume, velocity by mass,
/// pressure by volume. Where no gas is left it stays what it was.
void Strips::look_inside(const BodyPoints& bodies, const Scene& scene) {
  const Points& P = bodies.points;
  for (std::size_t k = 0; k < 4; ++k) {
    if (!edges_.of[k].open()) continue;
    Cells& cells = cells_[k];
    sums_.assign(cells.body.size(), {});
    for (std::size_t b = 0; b < bodies.ranges.size(); ++b) {
      if (!std::holds_alternative<IdealGas>(scene.bodies[b].material)) continue;
      for_points(bodies.ranges[b].full(), [&](std::size_t p) {
        const double distance = inward(k, P.x[p], P.y[p]);
        if (distance >= seen_cells * cell_across(k) || holds(P.x[p], P.y[p])) return;
        Sums& sum = sums_[cell_of(k, k < 2 ? P.y[p] : P.x[p])];
        sum.mass += P.mass[p], sum.own += P.mass[p], sum.volume += P.mass[p] / P.rho[p];
        sum.energy += P.mass[p] * P.energy[p];
        sum.px += P.mass[p] * P.vx[p], sum.py += P.mass[p] * P.vy[p];
      });
      for (std::size_t c = 0; c < sums_.size(); ++c) {
        if (sums_[c].own > sums_[c].largest) sums_[c].largest = sums_[c].own, cells.body[c] = static_cast<int>(b);
        sums_[c].own = 0;
      }
    }
    for (std::size_t c = 0; c < sums_.size(); ++c) {
      const Sums& sum = sums_[c];
      if (sum.mass == 0) continue;
      const double x = sum.px / sum.mass, y = sum.py / sum.mass, across = k < 2 ? x : y;
      cells.density[c] = sum.mass / sum.volume, cells.pressure[c] = gm1_ * sum.energy / sum.volume;
      cells.across[c] = low(k) ? across : -across, cells.along[c] = k < 2 ? y : x;
    }
  }
  find_gas_on_edges();
}

EdgeGas Strips::outside(std::size_t k, const EdgeGas& inside) const {
  const Edge& edge = edges_.of[k];
  const double pressure = gm1_ * edge.density * edge.energy;
  if (edge.kind == EdgeKind::outflow) return {edge.density, inside.across, inside.along, pressure};
  const double across = k < 2 ? edge.u : edge.v;
  return {edge.density, low(k) ? across : -across, k < 2 ? edge.v : edge.u, pressure};
}

void Strips::find_gas_on_edges() {
  for (std::size_t k = 0; k < 4; ++k) {
    Cells& cells = cells_[k];
    for (std::size_t c = 0; c < cells.body.size(); ++c) {
      const EdgeGas inside{cells.density[c], cells.across[c], cells.along[c], cells.pressure[c]};
      cells.on_edge[c] = gas_on_edge(edges_.of[k], outside(k, inside), inside, 1 + gm1_);
    }
  }
}

/// Linear between the middles of cells, where both have gas.
EdgeGas Strips::on_edge(std::size_t k, double along) const {
  const Cells& cells = cells_[k];
  const std::size_t here = cell_of(k, along);
  const double place = (along - first_along(k)) / cell_along(k) - (static_cast<double>(here) + 0.5);
  const std::size_t next = place < 0 ? (here == 0 ? here : here - 1) : std::min(here + 1, cells.body.size() - 1);
  const EdgeGas &a = cells.on_edge[here], &b = cells.on_edge[next];
  if (next == here || !(a.density > 0) || !(b.density > 0)) return a;
  const double s = std::min(1.0, std::abs(place));
  const auto mean = [s](double of_a, double of_b) { return of_a + s * (of_b - of_a); };
  return {mean(a.density, b.density), mean(a.across, b.across), mean(a.along, b.along), mean(a.pressure, b.pressure)};
}

/// A point's energy makes the pressure on the edge. Where splines find the density at the nodes and the stress comes
/// first, as in the robust set, it does so with that density; else it is the energy on the edge itself. For by linear
/// shape functions nodes feel V_p p = m_p (gamma - 1) i, in which the density drops out: a strip whose V_p p followed
/// the pressure on the edge would be gamma / (gamma - 1) times as stiff as the gas before it, and pump. Motions would
/// grow by 0.3 to 0.5 c / dx, out of rounding.
StepFindings Strips::set_strips(const BodyPoints& bodies, const Scene& scene) const {
  StepFindings found;
  Points& P = bodies.points;
  const bool robust = scene.method.kernel == Kernel::bspline && scene.method.order == StressOrder::usf;
  for (std::size_t b = 0; b < bodies.ranges.size(); ++b) {
    const auto* law = std::get_if<IdealGas>(&scene.bodies[b].material);
    if (!law) continue;
    found = find_at_points(bodies.ranges[b].full(), found, [&](std::size_t p, StepFindings& sum) {
      const int edge = edge_of(P.x[p], P.y[p]);
      if (edge == inside_) return;
      const auto k = static_cast<std::size_t>(edge % corner_);
      const EdgeGas gas = on_edge(k, k < 2 ? P.y[p] : P.x[p]);
      const double across = low(k) ? gas.across : -gas.across;
      P.vx[p] = k < 2 ? across : gas.along, P.vy[p] = k < 2 ? gas.along : across;
      P.forget_field(p);
      const bool by_nodes = law->rule == DensityRule::grid && robust;
      const bool fresh = edges_.of[k].kind == EdgeKind::inflow && gas.across > 0;
      const bool whole = -inward(k, P.x[p], P.y[p]) < whole_cells * cell_across(k);
      const double density = by_nodes && whole && !fresh ? P.rho[p] : gas.density;
      P.energy[p] = density > 0 ? gas.pressure / (gm1_ * density) : 0;
      const double pressure = by_nodes ? gas.pressure : gm1_ * P.rho[p] * P.energy[p];
      P.sxx[p] = P.syy[p] = -pressure, P.sxy[p] = 0;
      if (geometry_ == Geometry::axisymmetric) P.szz[p] = -pressure;
      const double c_squared = law->sound_speed_squared(P.energy[p]);
      sum.c_squared_max = std::max(sum.c_squared_max, c_squared);
      sum.wave_max = std::max(sum.wave_max, std::sqrt(c_squared) + std::hypot(P.vx[p], P.vy[p]));
    });
  }
  return found;
}

}  // namespace tether::mpm
