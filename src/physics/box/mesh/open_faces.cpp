// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/open_faces.hpp"

#include <cmath>
#include <map>

#include "base/numbers.hpp"

namespace tether::coupled {
namespace {

/// A node of open faces: these, and the axes along which it is held.
struct Corner {
  std::vector<std::size_t> faces;
  Vec<3> held{};
};

std::map<int, Corner> corners_of(const FlowMesh& mesh, std::span<const std::size_t> open,
                                 std::span<const std::uint8_t> held) {
  std::map<int, Corner> corners;
  for (const std::size_t f : open) {
    for (const int n : mesh.face_nodes(f)) corners[n].faces.push_back(f);
  }
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    if (!mesh.is_at_boundary(f)) continue;
    for (const int n : mesh.face_nodes(f)) {
      const auto found = corners.find(n);
      for (std::size_t a = 0; a < at(mesh.dim) && found != corners.end(); ++a) {
        if (held[f * at(mesh.dim) + a] != 0) found->second.held[a] = 1;
      }
    }
  }
  return corners;
}

/// How the share of a face's k-th node grows along the face, times the face's area: what is across it to the other
/// nodes, of a length or by half an edge.
Vec<3> slope_of_share(const FlowMesh& mesh, std::size_t f, std::size_t k) {
  const auto nodes = mesh.face_nodes(f);
  const Vec<3>& x = mesh.x[at(nodes[k])];
  if (mesh.dim == 2) {
    const Vec<3> from = minus(x, mesh.x[at(nodes[1 - k])]);
    const double length = std::sqrt(dot(from, from));
    return {from[0] / length, from[1] / length, 0};
  }
  const Vec<3> edge = minus(mesh.x[at(nodes[(k + 2) % 3])], mesh.x[at(nodes[(k + 1) % 3])]);
  Vec<3> slope = cross(mesh.area[f], edge);
  for (double& along : slope) along *= 0.5 / mesh.size_of(f);
  return slope;
}

}  // namespace

std::vector<Couple> couples_at(const FlowMesh& mesh, std::span<const std::size_t> open,
                               std::span<const std::uint8_t> held) {
  const std::size_t dim = at(mesh.dim);
  const std::map<int, Corner> corners = corners_of(mesh, open, held);
  std::vector<Couple> couples;
  for (const std::size_t f : open) {
    const auto nodes = mesh.face_nodes(f);
    for (std::size_t n = 0; n < dim; ++n) {
      const double out = mesh.area[f][n] / mesh.size_of(f);
      if (std::abs(out) < 0.5) continue;
      for (std::size_t k = 0; k < nodes.size(); ++k) {
        const Corner& corner = corners.at(nodes[k]);
        const Vec<3> slope = slope_of_share(mesh, f, k);
        for (std::size_t t = 0; t < dim; ++t) {
          const double by = -0.5 * out * slope[t] / static_cast<double>(corner.faces.size());
          for (const std::size_t g : corner.faces) {
            if (t == n) continue;
            if (corner.held[n] == 0) couples.push_back({g * dim + n, f * dim + t, by});
            if (corner.held[t] == 0) couples.push_back({g * dim + t, f * dim + n, -by});
          }
        }
      }
    }
  }
  return couples;
}

}  // namespace tether::coupled
