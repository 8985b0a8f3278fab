// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/gas_mixing.hpp"

#include <fmt/format.h>
#include <algorithm>

#include "loops/points.hpp"

namespace tether::mpm {
namespace {

/// Beyond what shocks and the contact of Sod's tube make of the energies of gases that meet.
constexpr double doubtful_ratio = 2;

bool from_cells(const Body& body) {
  const auto* gas = std::get_if<IdealGas>(&body.material);
  return gas && (gas->rule == DensityRule::cell || gas->rule == DensityRule::quadratic);
}

}  // namespace

GasMixing::GasMixing(const Scene& scene, const Frame& frame)
    : locator_(frame.shape), columns_(static_cast<std::size_t>(frame.shape.nx) + 1) {
  on_ = std::count_if(scene.bodies.begin(), scene.bodies.end(), from_cells) > 1;
  if (!on_) return;
  for (const Body& body : scene.bodies) {
    const auto* gas = std::get_if<IdealGas>(&body.material);
    if (gas && gas->rule == DensityRule::quadratic) reach_ = 1;
  }
  cells_.resize(columns_ * (static_cast<std::size_t>(frame.shape.ny) + 1));
}

void GasMixing::Span::add(const Span& other) {
  least = most == 0 ? other.least : std::min(least, other.least);
  most = std::max(most, other.most);
}

double GasMixing::Span::ratio(const Span& other) const {
  if (most == 0 || other.most == 0) return 1;
  return std::max({1.0, least / other.most, other.least / most});
}

void GasMixing::add_body(const Points& points, Slots range, double gm1) {
  held_.clear(), reached_.clear();
  for_points(points, range, [&](std::size_t p) {
    const CellPlace at = locator_.locate(points.x[p], points.y[p]);
    const std::size_t c = static_cast<std::size_t>(at.j + 1) * columns_ + static_cast<std::size_t>(at.i + 1);
    if (cells_[c].mass == 0) held_.push_back(c);
    cells_[c].mass += points.mass[p];
    cells_[c].energy += points.mass[p] * gm1 * points.energy[p];
    cells_[c].holds = true;
  });
  for (const std::size_t c : held_) spread(c);
  for (const std::size_t c : held_) cells_[c].mass = cells_[c].energy = 0;
}

/// To the cells that take part of their density from this one.
void GasMixing::spread(std::size_t cell) {
  const double energy = cells_[cell].energy / cells_[cell].mass;
  if (!(energy > 0)) return;
  for (int j = -reach_; j <= reach_; ++j) {
    for (int i = -reach_; i <= reach_; ++i) {
      const auto away = static_cast<std::ptrdiff_t>(columns_) * j + i;
      const auto c = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(cell) + away);
      if (cells_[c].here.most == 0) reached_.push_back(c);
      cells_[c].here.add({energy, energy});
    }
  }
}

void GasMixing::compare_with_earlier() {
  for (const std::size_t c : reached_) {
    Cell& cell = cells_[c];
    const double ratio = cell.here.ratio(cell.before);
    if (cell.holds && ratio > worst_.ratio) worst_ = {ratio, c};
    cell.before.add(cell.here);
    cell.here = {};
  }
}

void GasMixing::look(State& state, const Scene& scene, std::vector<std::string>& messages) {
  std::fill(cells_.begin(), cells_.end(), Cell{});
  worst_ = {};
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (!from_cells(scene.bodies[b])) continue;
    add_body(state.points, state.ranges[b], std::get<IdealGas>(scene.bodies[b].material).gm1);
    compare_with_earlier();
  }
  state.gases_apart = std::max(state.gases_apart, worst_.ratio);
  if (worst_.ratio <= doubtful_ratio || !note_warning(state.warned, PointDoubt::mixing)) return;
  const BackgroundGrid& grid = state.grid.frame.shape;
  const double x = grid.x0 + (static_cast<double>(worst_.cell % columns_) - 0.5) * grid.dx;
  const double y = grid.y0 + (static_cast<double>(worst_.cell / columns_) - 0.5) * grid.dy;
  messages.push_back(fmt::format(
      "t = {:.6g}: two gases share the density of the cell at ({:.6g}, {:.6g}), and their energies differ by a factor "
      "of "
      "{:.3g}: so do the pressures that are written for them there, and what is computed from pressures: forces "
      "without viscosity are right; method='robust' or density='continuity' of $mpm keeps gases apart",
      state.time, x, y, worst_.ratio));
}

}  // namespace tether::mpm
