// SPDX-License-Identifier: GPL-3.0-or-later
// The points of the strips: how they are laid at the start, made at the far end, and taken out of the arrays.
#include <algorithm>
#include <cmath>

#include "solvers/mpm/strips.hpp"

#include "loops/points.hpp"

namespace tether::mpm {
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
    for_points(bodies.ranges[b], [&](std::size_t p) {
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
      for_points(bodies.ranges[b], [&](std::size_t p) {
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

}  // namespace tether::mpm
