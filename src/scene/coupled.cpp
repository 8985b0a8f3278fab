// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/coupled.hpp"

namespace tether {

bool AxisBox::contains(const std::array<double, 3>& place) const {
  for (std::size_t i = 0; i < 3; ++i) {
    const double slack = 1e-9 * (high[i] - low[i]);
    if (place[i] < low[i] - slack || place[i] > high[i] + slack) return false;
  }
  return true;
}

const char* coupling_mode_name(CouplingMode mode) {
  constexpr std::array names{"symmetric", "cut-cell", "splitting", "paper"};
  return names[static_cast<std::size_t>(mode)];
}

std::vector<std::size_t> faces_of(const Jet& jet, const StaggeredGrid& grid) {
  const int axis = axis_of_side(jet.side);
  const auto across = static_cast<std::size_t>(axis);
  std::array<int, 3> first{}, end = grid.n, f{};
  first[across] = is_low_side(jet.side) ? 0 : grid.n[across];
  end[across] = first[across] + 1;
  std::vector<std::size_t> faces;
  for (f[2] = first[2]; f[2] < end[2]; ++f[2]) {
    for (f[1] = first[1]; f[1] < end[1]; ++f[1]) {
      for (f[0] = first[0]; f[0] < end[0]; ++f[0]) {
        std::array<double, 3> middle{grid.middle(0, f[0]), grid.middle(1, f[1]), grid.middle(2, f[2])};
        middle[across] = jet.patch.low[across];
        if (jet.patch.contains(middle)) faces.push_back(grid.face(axis, f));
      }
    }
  }
  return faces;
}

std::size_t cell_at(const Jet& jet, const StaggeredGrid& grid, std::size_t face) {
  auto cell = grid.place_of_face(axis_of_side(jet.side), face);
  if (!is_low_side(jet.side)) --cell[static_cast<std::size_t>(axis_of_side(jet.side))];
  return grid.cell(cell);
}

JetFaces::JetFaces(const Coupled& coupled) {
  for (std::size_t k = 0; k < coupled.jets.size(); ++k) {
    const int axis = axis_of_side(coupled.jets[k].side);
    auto& jets = jet_[static_cast<std::size_t>(axis)];
    if (jets.empty()) jets.assign(coupled.grid.face_count(axis), none);
    for (const std::size_t face : faces_of(coupled.jets[k], coupled.grid)) jets[face] = static_cast<int>(k);
  }
}

int JetFaces::jet_of(int axis, std::size_t face) const {
  const auto& jets = jet_[static_cast<std::size_t>(axis)];
  return jets.empty() ? none : jets[face];
}

CoupledSystems systems_of(const Coupled& coupled) {
  if (coupled.systems != CoupledSystems::automatic) return coupled.systems;
  const bool large = static_cast<double>(coupled.grid.cell_count()) > most_cells_of_factors;
  return coupled.grid.dim == 3 && large ? CoupledSystems::krylov : CoupledSystems::direct;
}

}  // namespace tether
