// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/coupled/blend_cut_faces.hpp"

#include <algorithm>
#include <cmath>

#include "base/index.hpp"

namespace tether::coupled {
namespace {

constexpr double rounding = 1e-9;  // of a box

using Place = std::array<int, 3>;

bool open(const FlowDomain& domain, int axis, const Place& face) {
  const auto m = domain.grid.faces(axis);
  for (std::size_t b = 0; b < face.size(); ++b) {
    if (face[b] < 0 || face[b] >= m[b]) return false;
  }
  return domain.face[at(axis)][domain.grid.face(axis, face)] == FaceKind::open;
}

/// Whether fluid goes straight from one of the two cells beside a face to the same one beside the next face on a side.
bool joined(const FlowDomain& domain, int axis, const Place& face, int across, bool up) {
  if (across == axis) return true;  // both are faces of one cell
  for (const int back : {1, 0}) {
    Place between = face;
    between[at(axis)] -= back, between[at(across)] += up ? 1 : 0;
    if (open(domain, across, between)) return true;
  }
  return false;
}

/// Of a face's velocity and those of the faces beside it that it is joined to.
struct Around {
  double mean = 0;     ///< by volume
  double fastest = 0;  ///< the largest size
};

Around around(const FlowDomain& domain, int axis, std::size_t f, const std::vector<double>& v) {
  const StaggeredGrid& grid = domain.grid;
  const std::vector<double>& volume = domain.volume[at(axis)];
  const Place place = grid.place_of_face(axis, f);
  double sum = volume[f] * v[f], weights = volume[f], fastest = std::abs(v[f]);
  for (int across = 0; across < grid.dim; ++across) {
    for (const bool up : {false, true}) {
      Place next = place;
      next[at(across)] += up ? 1 : -1;
      if (!open(domain, axis, next) || !joined(domain, axis, place, across, up)) continue;
      const std::size_t g = grid.face(axis, next);
      sum += volume[g] * v[g], weights += volume[g], fastest = std::max(fastest, std::abs(v[g]));
    }
  }
  return {sum / weights, fastest};
}

}  // namespace

void blend_cut_faces(const FlowDomain& domain, double h, FaceValues& v) {
  const StaggeredGrid& grid = domain.grid;
  for (int axis = 0; axis < grid.dim; ++axis) {
    const std::vector<double> before = v[at(axis)];
    for (std::size_t f = 0; f < before.size(); ++f) {
      if (domain.face[at(axis)][f] != FaceKind::open) continue;
      const int i = grid.place_of_face(axis, f)[at(axis)];
      const double whole = grid.volume() * (i == 0 || i == grid.n[at(axis)] ? 0.5 : 1),
                   lacks = 1 - domain.volume[at(axis)][f] / whole;
      if (lacks < rounding) continue;
      const Around about = around(domain, axis, f, before);
      const double taken = lacks * -std::expm1(-h * about.fastest / grid.d[at(axis)]);
      v[at(axis)][f] += taken * (about.mean - before[f]);
    }
  }
}

}  // namespace tether::coupled
