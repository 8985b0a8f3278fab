// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/coupled.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/vec.hpp"
#include "grid/solid_surface.hpp"
#include "model/scene.hpp"

namespace tether {
namespace {

/// Root of the mean square distance of a region's nodes from their middle [length].
double radius_of_gyration(const Mesh& mesh, int region) {
  std::set<int> nodes;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    if (mesh.region[e] != region) continue;
    nodes.insert(mesh.element(e), mesh.element(e) + node_count_of(mesh.kind));
  }
  Vec<3> middle{};
  double squares = 0;
  const double count = static_cast<double>(nodes.size());
  for (const int node : nodes) {
    const Vec<3> x = place_of(mesh.x, node, mesh.dim());
    for (std::size_t i = 0; i < 3; ++i) middle[i] += x[i] / count;
    squares += dot(x, x) / count;
  }
  return std::sqrt(std::max(0.0, squares - dot(middle, middle)));
}

}  // namespace

Box<3> cells_of(const Box<3>& box, const StaggeredGrid& grid) {
  Box<3> cells = box;
  for (int axis = 0; axis < grid.dim; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const double slack = Box<3>::rounding * (box.high[i] - box.low[i]) / grid.d[i];
    const double first = std::ceil((box.low[i] - grid.low[i]) / grid.d[i] - 0.5 - slack),
                 last = std::floor((box.high[i] - grid.low[i]) / grid.d[i] - 0.5 + slack);
    cells.low[i] = grid.low[i] + std::max(first, 0.0) * grid.d[i];
    cells.high[i] = grid.low[i] + std::min(last + 1, static_cast<double>(grid.n[i])) * grid.d[i];
  }
  return cells;
}

bool in_obstacle(const Coupled& coupled, const Vec<3>& x) {
  return std::ranges::any_of(coupled.obstacles, [&](const Box<3>& box) { return box.contains(x); }) ||
         std::ranges::any_of(coupled.shaped, [&](const Obstacle& of) { return contains(of.figure, x); });
}

Vec<3> gravity_of(const Scene& scene) { return {scene.coupled()->gravity_x, scene.gravity, 0}; }

bool has_fluid_beyond(const Coupled& coupled, int side) {
  const BoxSide kind = coupled.sides[static_cast<std::size_t>(side)];
  return kind == BoxSide::open ||
         (is_wall(kind) && std::any_of(coupled.openings.begin(), coupled.openings.end(),
                                       [&](const Opening& opening) { return opening.side == side; }));
}

/// E angle^4 / 4 a volume, of rho (rate radius)^2 / 2.
double linear_gain(const SolidRegion& region, double rate, double radius, double tstep) {
  const double angle = rate * tstep;
  if (!(angle > 0)) return 0;
  return youngs_modulus(region.law) * std::pow(angle, 4) / (2 * region.density * std::pow(rate * radius, 2));
}

double linear_gain(const Solids& solids, double tstep) {
  double most = 0;
  for (std::size_t r = 0; r < solids.regions.size(); ++r) {
    const SolidRegion& region = solids.regions[r];
    if (region.spin == Vec<3>{}) continue;
    const double radius = radius_of_gyration(solids.mesh, static_cast<int>(r));
    most = std::max(most, linear_gain(region, std::sqrt(dot(region.spin, region.spin)), radius, tstep));
  }
  return most;
}

bool keeps_energy(const Coupled& coupled, const Solids& solids, double tstep) {
  if (coupled.step != SolidsStep::automatic) return coupled.step == SolidsStep::energy;
  if (!coupled.coupling.balances_power()) return false;
  return solids.contact || linear_gain(solids, tstep) > most_linear_gain;
}

Systems systems_of(const Coupled& coupled) {
  if (coupled.systems != Systems::automatic) return coupled.systems;
  if (coupled.mesh) return coupled.grid.dim == 3 ? Systems::krylov : Systems::direct;
  const bool large = static_cast<double>(coupled.grid.cell_count()) > most_cells_of_factors;
  return coupled.grid.dim == 3 && large ? Systems::krylov : Systems::direct;
}

namespace {

constexpr double rounding = 1e-9;  // of a face

/// A face's extent along the axes of its side; of length 0 across.
Box<3> extent_of(int side, const StaggeredGrid& grid, const std::array<int, 3>& place) {
  Box<3> box;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    box.low[i] = grid.low[i] + place[i] * grid.d[i];
    box.high[i] = axis == axis_of_side(side) ? box.low[i] : box.low[i] + grid.d[i];
  }
  return box;
}

/// The two axes along a side.
std::array<std::size_t, 2> axes_along(int side) {
  const auto across = static_cast<std::size_t>(axis_of_side(side));
  return across == 0 ? std::array<std::size_t, 2>{1, 2} : std::array<std::size_t, 2>{0, 3 - across};
}

/// Places of a face and its patches where one of them begins or ends, along an axis.
std::vector<double> cuts(const Box<3>& face, const std::vector<Box<3>>& patches, std::size_t axis) {
  const double slack = rounding * (face.high[axis] - face.low[axis]);
  std::vector<double> places{face.low[axis], face.high[axis]};
  for (const Box<3>& patch : patches) {
    for (const double x : {patch.low[axis], patch.high[axis]}) {
      if (x > face.low[axis] + slack && x < face.high[axis] - slack) places.push_back(x);
    }
  }
  std::sort(places.begin(), places.end());
  return places;
}

/// Returns for each patch the part of a face that it has, where the last of those that reach there has a place.
std::vector<double> parts(int side, const Box<3>& face, const std::vector<Box<3>>& patches) {
  const auto [a, b] = axes_along(side);
  const std::vector<double> along = cuts(face, patches, a), other = cuts(face, patches, b);
  std::vector<double> part(patches.size(), 0.0);
  const double area = (face.high[a] - face.low[a]) * (face.high[b] - face.low[b]);
  for (std::size_t i = 0; i + 1 < along.size(); ++i) {
    for (std::size_t j = 0; j + 1 < other.size(); ++j) {
      const double x = 0.5 * (along[i] + along[i + 1]), y = 0.5 * (other[j] + other[j + 1]);
      for (std::size_t k = patches.size(); k-- > 0;) {
        const Box<3>& patch = patches[k];
        if (x < patch.low[a] || x > patch.high[a] || y < patch.low[b] || y > patch.high[b]) continue;
        part[k] += (along[i + 1] - along[i]) * (other[j + 1] - other[j]) / area;
        break;
      }
    }
  }
  return part;
}

/// Calls f(face, its place) for the faces of a side.
template <class Function>
void for_faces(int side, const StaggeredGrid& grid, const Function& f) {
  const auto across = static_cast<std::size_t>(axis_of_side(side));
  std::array<int, 3> first{}, end = grid.n, place{};
  first[across] = is_low_side(side) ? 0 : grid.n[across];
  end[across] = first[across] + 1;
  for (place[2] = first[2]; place[2] < end[2]; ++place[2]) {
    for (place[1] = first[1]; place[1] < end[1]; ++place[1]) {
      for (place[0] = first[0]; place[0] < end[0]; ++place[0]) f(grid.face(axis_of_side(side), place), place);
    }
  }
}

}  // namespace

std::vector<FacePart> faces_of(int side, const Box<3>& patch, const StaggeredGrid& grid) {
  std::vector<FacePart> faces;
  for_faces(side, grid, [&](std::size_t face, const std::array<int, 3>& place) {
    const double part = parts(side, extent_of(side, grid, place), {patch})[0];
    if (part > rounding) faces.push_back({face, part});
  });
  return faces;
}

std::size_t cell_at(int side, const StaggeredGrid& grid, std::size_t face) {
  auto cell = grid.place_of_face(axis_of_side(side), face);
  if (!is_low_side(side)) --cell[static_cast<std::size_t>(axis_of_side(side))];
  return grid.cell(cell);
}

SideFaces::SideFaces(const Coupled& coupled) {
  for (int axis = 0; axis < coupled.grid.dim; ++axis)
    number_[static_cast<std::size_t>(axis)].assign(coupled.grid.face_count(axis), -1);
  for (int side = 0; side < 2 * coupled.grid.dim; ++side) add_side(coupled, side);
}

void SideFaces::add_side(const Coupled& coupled, int side) {
  std::vector<Box<3>> patches;
  std::vector<int> jets;  // of each patch, -1 of an opening
  for (const Opening& opening : coupled.openings) {
    if (opening.side == side) patches.push_back(opening.patch), jets.push_back(-1);
  }
  for (std::size_t k = 0; k < coupled.jets.size(); ++k) {
    if (coupled.jets[k].side == side) patches.push_back(coupled.jets[k].patch), jets.push_back(static_cast<int>(k));
  }
  const bool open_side = !is_wall(coupled.sides[static_cast<std::size_t>(side)]);
  for_faces(side, coupled.grid, [&](std::size_t f, const std::array<int, 3>& place) {
    Face face;
    const std::vector<double> part = parts(side, extent_of(side, coupled.grid, place), patches);
    for (std::size_t k = 0; k < part.size(); ++k) {
      if (part[k] <= rounding) continue;
      if (jets[k] < 0) face.open += part[k];
      if (jets[k] >= 0) face.jets.push_back({jets[k], part[k] < 1 - rounding ? part[k] : 1});
    }
    if (open_side || face.open > 1 - rounding) face.open = 1;
    if (!face.jets.empty()) face.open = 0;
    number_[static_cast<std::size_t>(axis_of_side(side))][f] = static_cast<int>(faces_.size());
    faces_.push_back(std::move(face));
  });
}

}  // namespace tether
