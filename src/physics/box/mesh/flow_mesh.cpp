// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/flow_mesh.hpp"

#include <algorithm>
#include <utility>

#include "base/numbers.hpp"

namespace tether::coupled {
namespace {

Vec<3> mean_place(const FlowMesh& mesh, std::span<const int> nodes) {
  Vec<3> sum{};
  for (const int n : nodes) {
    for (std::size_t a = 0; a < 3; ++a) sum[a] += mesh.x[at(n)][a];
  }
  for (double& value : sum) value /= static_cast<double>(nodes.size());
  return sum;
}

/// Twice or six times the volume of a cell.
double parallelepiped(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c, const Vec<3>* d) {
  const Vec<3> u = minus(b, a), v = minus(c, a);
  return d == nullptr ? u[0] * v[1] - u[1] * v[0] : dot(cross(u, v), minus(*d, a));
}

double volume_of(const FlowMesh& mesh, const std::array<Vec<3>, 4>& corner) {
  return mesh.dim == 2 ? 0.5 * parallelepiped(corner[0], corner[1], corner[2], nullptr)
                       : parallelepiped(corner[0], corner[1], corner[2], &corner[3]) / 6;
}

std::array<Vec<3>, 4> corners_of(const FlowMesh& mesh, std::size_t cell) {
  std::array<Vec<3>, 4> corner{};
  const auto nodes = mesh.nodes_of(cell);
  for (std::size_t k = 0; k < nodes.size(); ++k) corner[k] = mesh.x[at(nodes[k])];
  return corner;
}

/// The nodes of a cell's face that is opposite to node k, in an order that makes its normal point out of the cell.
std::array<int, 3> nodes_opposite(std::span<const int> nodes, std::size_t k) {
  if (nodes.size() == 3) return {nodes[(k + 1) % 3], nodes[(k + 2) % 3], -1};
  constexpr std::array<std::array<std::size_t, 3>, 4> opposite{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  return {nodes[opposite[k][0]], nodes[opposite[k][1]], nodes[opposite[k][2]]};
}

Vec<3> area_of(const FlowMesh& mesh, const std::array<int, 3>& nodes) {
  const Vec<3>&a = mesh.x[at(nodes[0])], &b = mesh.x[at(nodes[1])];
  const Vec<3> along = minus(b, a);
  if (mesh.dim == 2) return {along[1], -along[0], 0};
  Vec<3> area = cross(along, minus(mesh.x[at(nodes[2])], a));
  for (double& value : area) value *= 0.5;
  return area;
}

}  // namespace

Vec<3> FlowMesh::out_of(std::size_t cell, std::size_t f) const {
  const double sign = at(cells_of_face[f][0]) == cell ? 1 : -1;
  return {sign * area[f][0], sign * area[f][1], sign * area[f][2]};
}

Vec<3> FlowMesh::middle_of_face(std::size_t f) const { return mean_place(*this, face_nodes(f)); }

/// A node's share falls from 1 to 0 on the way to the face opposite to it.
void FlowMesh::find_shares() {
  cell_middle.clear(), share_slope.clear();
  for (std::size_t cell = 0; cell < cells(); ++cell) {
    cell_middle.push_back(mean_place(*this, nodes_of(cell)));
    for (const int f : faces_of(cell)) {
      const Vec<3> out = out_of(cell, at(f));
      const double by = -1 / (dim * volume[cell]);
      share_slope.push_back({by * out[0], by * out[1], by * out[2]});
    }
  }
}

/// Faces are numbered as cells come to them; those that a later cell may have wait in a list at their lowest node.
void FlowMesh::find_faces() {
  const std::size_t per_cell = corners(), per_face = at(dim);
  std::vector<std::vector<std::pair<std::array<int, 3>, int>>> waiting(x.size());
  volume.clear(), cells_of_face.clear(), nodes_of_face.clear(), area.clear(), face.clear();
  for (std::size_t cell = 0; cell < cells(); ++cell) {
    double size = volume_of(*this, corners_of(*this, cell));
    if (size < 0) std::swap(nodes[cell * per_cell], nodes[cell * per_cell + 1]), size = -size;
    volume.push_back(size);
    for (std::size_t k = 0; k < per_cell; ++k) {
      const std::array<int, 3> of = nodes_opposite(nodes_of(cell), k);
      std::array<int, 3> key = of;
      std::sort(key.begin(), key.begin() + static_cast<std::ptrdiff_t>(per_face));
      auto& list = waiting[at(key[0])];
      const auto found = std::ranges::find(list, key, [](const auto& entry) { return entry.first; });
      if (found != list.end()) {
        cells_of_face[at(found->second)][1] = static_cast<int>(cell);
        face.push_back(found->second);
        list.erase(found);
        continue;
      }
      face.push_back(static_cast<int>(cells_of_face.size()));
      list.emplace_back(key, face.back());
      nodes_of_face.insert(nodes_of_face.end(), of.begin(), of.begin() + static_cast<std::ptrdiff_t>(per_face));
      area.push_back(area_of(*this, of));
      cells_of_face.push_back({static_cast<int>(cell), -1});
    }
  }
  boundary.assign(cells_of_face.size(), {});
  find_shares();
  Parts parts = parts_of(std::vector<std::uint8_t>(cells(), 0), 0);
  region = std::move(parts.of), regions = parts.count;
}

std::vector<std::uint8_t> FlowMesh::faces_of_flat_cells() const {
  constexpr double flat = 0.35;  // height over the root of the largest face's area
  std::vector<std::uint8_t> marked(faces(), 0);
  for (std::size_t cell = 0; cell < cells(); ++cell) {
    const double largest = largest_face(cell);
    if (dim * volume[cell] / largest >= flat * std::sqrt(largest)) continue;
    for (const int f : faces_of(cell)) marked[at(f)] = 1;
  }
  return marked;
}

std::vector<std::size_t> FlowMesh::cells_across_gaps(double least) const {
  constexpr double opposite = -0.5;
  std::vector<Vec<3>> out(x.size());  // of the boundary at each node, summed over its faces
  for (std::size_t f = 0; f < faces(); ++f) {
    if (!is_at_boundary(f)) continue;
    for (const int n : face_nodes(f)) {
      for (std::size_t a = 0; a < 3; ++a) out[at(n)][a] += area[f][a];
    }
  }
  std::vector<std::size_t> across;
  for (std::size_t cell = 0; cell < cells(); ++cell) {
    for (std::size_t k = 0; k < corners(); ++k) {
      const std::size_t f = at(faces_of(cell)[k]);
      const Vec<3>& beyond = out[at(nodes_of(cell)[k])];
      if (!is_at_boundary(f) || dim * volume[cell] <= least * size_of(f)) continue;
      if (dot(beyond, area[f]) < opposite * std::sqrt(dot(beyond, beyond)) * size_of(f)) across.push_back(cell);
    }
  }
  return across;
}

std::vector<double> FlowMesh::volumes_of(std::span<const int> part, int count) const {
  std::vector<double> volumes(at(count), 0.0);
  for (std::size_t cell = 0; cell < cells(); ++cell) {
    if (part[cell] >= 0) volumes[at(part[cell])] += volume[cell];
  }
  return volumes;
}

std::vector<std::uint8_t> FlowMesh::nodes_at_boundary() const {
  std::vector<std::uint8_t> marked(x.size(), 0);
  for (std::size_t f = 0; f < faces(); ++f) {
    if (!is_at_boundary(f)) continue;
    for (const int n : face_nodes(f)) marked[at(n)] = 1;
  }
  return marked;
}

FlowMesh::Parts FlowMesh::parts_of(std::span<const std::uint8_t> marks, std::uint8_t mark) const {
  Parts parts{std::vector<int>(cells(), -1)};
  std::vector<std::size_t> next;
  const auto reach = [&](std::size_t cell) {
    if (marks[cell] == mark && parts.of[cell] < 0) parts.of[cell] = parts.count, next.push_back(cell);
  };
  for (std::size_t first = 0; first < cells(); ++first) {
    if (reach(first); next.empty()) continue;
    while (!next.empty()) {
      const std::size_t cell = next.back();
      next.pop_back();
      for (const int f : faces_of(cell)) {
        for (const int other : cells_of_face[at(f)]) {
          if (other >= 0) reach(at(other));
        }
      }
    }
    ++parts.count;
  }
  return parts;
}

}  // namespace tether::coupled
