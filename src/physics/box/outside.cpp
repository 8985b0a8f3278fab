// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/outside.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "base/vec.hpp"

namespace tether::coupled {

FaceValues face_values(const StaggeredGrid& grid, double value) {
  FaceValues values;
  for (int axis = 0; axis < grid.dim; ++axis)
    values[static_cast<std::size_t>(axis)].assign(grid.face_count(axis), value);
  return values;
}

namespace {

/// Cells that obstacles and voids leave to the fluid.
std::vector<std::uint8_t> cells_for_fluid(const Coupled& scene) {
  std::vector<std::uint8_t> fluid(scene.grid.cell_count(), 1);
  for (std::size_t c = 0; c < fluid.size(); ++c) {
    const auto middle = scene.grid.middle(scene.grid.place_of_cell(c));
    for (const auto* boxes : {&scene.obstacles, &scene.voids}) {
      for (const Box<3>& box : *boxes) fluid[c] = box.contains(middle) ? 0 : fluid[c];
    }
  }
  return fluid;
}

/// The part of a cell that lies in a box.
double part_in(const Box<3>& box, const StaggeredGrid& grid, const std::array<int, 3>& cell) {
  constexpr double rounding = 1e-9;  // of a cell
  double part = 1;
  for (int axis = 0; axis < grid.dim; ++axis) {
    const double low = (box.low[at(axis)] - grid.low[at(axis)]) / grid.d[at(axis)] - cell[at(axis)],
                 high = (box.high[at(axis)] - grid.low[at(axis)]) / grid.d[at(axis)] - cell[at(axis)];
    const double along = (high > 1 - rounding ? 1 : high) - (low < rounding ? 0 : low);
    part *= along > rounding ? along : 0;
  }
  return part;
}

/// Returns for each row of cells the value that all of its cells have; zero where they differ or there is none.
std::vector<double> layers_of(const StaggeredGrid& grid, const std::vector<std::uint8_t>& fluid,
                              const std::vector<double>& values) {
  std::vector<double> low(at(grid.n[1]), INFINITY), high(at(grid.n[1]), -INFINITY);
  for (std::size_t c = 0; c < values.size(); ++c) {
    if (fluid[c] == 0) continue;
    const std::size_t row = at(grid.place_of_cell(c)[1]);
    low[row] = std::min(low[row], values[c]), high[row] = std::max(high[row], values[c]);
  }
  for (std::size_t row = 0; row < low.size(); ++row) {
    if (low[row] != high[row]) low[row] = 0;
  }
  return low;
}

}  // namespace

FirstSmoke first_smoke(const Coupled& scene) {
  const StaggeredGrid& grid = scene.grid;
  FirstSmoke first{std::vector<double>(grid.cell_count(), 0.0), std::vector<double>(grid.cell_count(), 0.0)};
  for (const SmokeBox& of : scene.smoke_boxes) {
    for (std::size_t c = 0; c < first.density.size(); ++c) {
      const double part = part_in(of.box, grid, grid.place_of_cell(c));
      first.density[c] += part * of.density, first.temperature[c] += part * of.temperature;
    }
  }
  return first;
}

Outside::Outside(const Coupled& scene, const Vec<3>& gravity) : scene_(scene), gravity_(gravity) {
  const StaggeredGrid& grid = scene.grid;
  const FirstSmoke first = first_smoke(scene);
  const std::vector<std::uint8_t> fluid = cells_for_fluid(scene);
  density_ = layers_of(grid, fluid, first.density), temperature_ = layers_of(grid, fluid, first.temperature);
  std::vector<double> up;  // acceleration of each row
  for (int row = 0; row < grid.n[1]; ++row)
    up.push_back(scene.smoke_lift * temperature(row) - scene.smoke_weight * density(row));
  place_.push_back(grid.low[1]), lifted_.push_back(0);
  for (int row = 0; row <= grid.n[1]; ++row) {  // half a cell to the first middle and from the last
    const bool last = row == grid.n[1];
    const double below = up[at(std::max(row - 1, 0))], above = up[at(std::min(row, grid.n[1] - 1))];
    place_.push_back(last ? grid.high(1) : grid.middle(1, row));
    lifted_.push_back(lifted_.back() + (row == 0 || last ? 0.5 : 1) * grid.d[1] * 0.5 * (below + above));
  }
}

double Outside::lifted(double y) const {
  const auto above = std::upper_bound(place_.begin(), place_.end(), y);
  if (above == place_.begin()) return lifted_.front();
  if (above == place_.end()) return lifted_.back();
  const std::size_t k = static_cast<std::size_t>(above - place_.begin());
  const double part = (y - place_[k - 1]) / (place_[k] - place_[k - 1]);
  return (1 - part) * lifted_[k - 1] + part * lifted_[k];
}

double Outside::pressure(double y) const {
  return scene_.density * (gravity_[1] * (y - scene_.level) + lifted(y) - lifted(scene_.level));
}

double Outside::at_rest(const Vec<3>& x) const { return pressure(x[1]) + scene_.density * gravity_[0] * x[0]; }

double Outside::pressure_beyond(int side, double y) const { return presses(side) ? pressure(y) : 0; }

bool Outside::has_smoke() const {
  const auto some = [](double value) { return value != 0; };
  return std::any_of(density_.begin(), density_.end(), some) ||
         std::any_of(temperature_.begin(), temperature_.end(), some);
}

/// Calls f(axis, face, pressure outside, +1 where that pushes along the axis, or -1).
template <class Function>
void Outside::each_face(const FlowDomain& domain, const Function& f) const {
  const StaggeredGrid& grid = domain.grid;
  for (int side = 0; side < 2 * grid.dim; ++side) {
    if (!has_fluid_beyond(scene_, side)) continue;
    const int axis = axis_of_side(side);
    each_face_of_side(grid, side, [&](std::size_t face) {
      if (domain.face[at(axis)][face] != FaceKind::open) return;
      const int row = grid.place_of_face(axis, face)[1];
      const double y = axis == 1 ? grid.face_place(1, row) : grid.middle(1, row);
      f(at(axis), face, pressure_beyond(side, y), is_low_side(side) ? 1.0 : -1.0);
    });
  }
}

void Outside::press(const FlowDomain& domain, double h, FaceValues& v) const {
  each_face(domain, [&](std::size_t axis, std::size_t face, double p, double along) {
    v[axis][face] += along * h / scene_.density * domain.area[axis][face] * p / domain.volume[axis][face];
  });
}

double Outside::power(const FlowDomain& domain, const FaceValues& v) const {
  double sum = 0;
  each_face(domain, [&](std::size_t axis, std::size_t face, double p, double along) {
    sum += along * p * domain.area[axis][face] * v[axis][face];
  });
  return sum;
}

}  // namespace tether::coupled
