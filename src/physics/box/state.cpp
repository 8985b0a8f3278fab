// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/state.hpp"

#include <array>

#include "base/numbers.hpp"
#include "physics/box/outside.hpp"

namespace tether::coupled {
namespace {

/// |v|^2 at a face of a cell.
double square_at(const StaggeredGrid& grid, const FaceValues& v, int axis, std::size_t face, std::size_t cell) {
  double square = v[at(axis)][face] * v[at(axis)][face];
  for (int across = 0; across < grid.dim; ++across) {
    if (across == axis) continue;
    auto place = grid.place_of_cell(cell);
    const double low = v[at(across)][grid.face(across, place)];
    ++place[at(across)];
    const double high = v[at(across)][grid.face(across, place)];
    square += 0.5 * (low * low + high * high);
  }
  return square;
}

bool is_fluid(const FlowDomain& domain, int cell) { return cell >= 0 && domain.kind[at(cell)] == CellKind::fluid; }

/// Through one face, into the one fluid cell next to it; zero where there are two.
double through(const Coupled& scene, const FlowDomain& domain, const FaceValues& v, int axis, std::size_t face) {
  const auto [low, high] = cells_beside(domain.grid, axis, face);
  if (is_fluid(domain, low) == is_fluid(domain, high)) return 0;
  const bool into_high = is_fluid(domain, high);
  const double flux = domain.area[at(axis)][face] * v[at(axis)][face] * (into_high ? 1 : -1);
  return 0.5 * scene.density * flux * square_at(domain.grid, v, axis, face, at(into_high ? high : low));
}

}  // namespace

CarriedIn carried_in(const Coupled& scene, const FlowDomain& domain, const FaceValues& v, double h) {
  const StaggeredGrid& grid = domain.grid;
  CarriedIn in;
  for (int side = 0; side < 2 * grid.dim; ++side) {
    const int axis = axis_of_side(side);
    each_face_of_side(grid, side, [&](std::size_t face) {
      const FaceKind kind = domain.face[at(axis)][face];
      if (kind == FaceKind::closed) return;
      (kind == FaceKind::open ? in.open_sides : in.jets) += h * through(scene, domain, v, axis, face);
    });
  }
  if (scene.voids.empty() && !scene.cavities_only) return in;
  for (int axis = 0; axis < grid.dim; ++axis) {
    for (std::size_t face = 0; face < v[at(axis)].size(); ++face) {
      const int i = grid.place_of_face(axis, face)[at(axis)];
      if (i == 0 || i == grid.n[at(axis)] || domain.face[at(axis)][face] != FaceKind::open) continue;
      in.open_sides += h * through(scene, domain, v, axis, face);
    }
  }
  return in;
}

void go_back(const CoupledState& before, CoupledState& state) {
  constexpr std::array costs{&CoupledState::iterations, &CoupledState::lu_solutions, &CoupledState::newton_steps,
                             &CoupledState::contact_solutions, &CoupledState::passes};
  std::array<long long, costs.size()> spent;
  for (std::size_t k = 0; k < costs.size(); ++k) spent[k] = state.*costs[k];
  state = before;
  for (std::size_t k = 0; k < costs.size(); ++k) state.*costs[k] = spent[k];
}

}  // namespace tether::coupled
