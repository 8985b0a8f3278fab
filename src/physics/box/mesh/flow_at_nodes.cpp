// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/flow_at_nodes.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers.hpp"

namespace tether::coupled {
namespace {

constexpr int linear = 5, quadratic = 9;  // numbers of the stream functions of such velocities

/// The cells about each node.
class CellsAbout {
 public:
  explicit CellsAbout(const FlowMesh& mesh) : mesh_(mesh), first_(mesh.x.size() + 1, 0) {
    for (const int n : mesh.nodes) ++first_[at(n) + 1];
    for (std::size_t n = 0; n < mesh.x.size(); ++n) first_[n + 1] += first_[n];
    cell_.resize(mesh.nodes.size());
    gathered_.assign(mesh.faces(), mesh.x.size());
    std::vector<std::size_t> next = first_;
    for (std::size_t k = 0; k < mesh.nodes.size(); ++k) cell_[next[at(mesh.nodes[k])]++] = k / mesh.corners();
  }
  std::span<const std::size_t> of(std::size_t node) const {
    return std::span(cell_).subspan(first_[node], first_[node + 1] - first_[node]);
  }
  /// Gathers the faces of these cells and of those about their nodes.
  void faces_near(std::size_t node, std::vector<int>& faces) {
    faces.clear();
    for (const std::size_t cell : of(node)) {
      for (const int next : mesh_.nodes_of(cell)) {
        for (const std::size_t of_next : of(at(next))) {
          for (const int f : mesh_.faces_of(of_next)) {
            if (std::exchange(gathered_[at(f)], node) != node) faces.push_back(f);
          }
        }
      }
    }
  }

 private:
  const FlowMesh& mesh_;
  std::vector<std::size_t> first_, cell_;
  std::vector<std::size_t> gathered_;  // for which node each face was last
};

/// Fits the stream functions of nodes.
class NodeFits {
 public:
  NodeFits(const FlowMesh& mesh, const FaceValues& v)
      : mesh_(mesh), about_(mesh), at_boundary_(mesh.nodes_at_boundary()) {
    for (std::size_t f = 0; f < mesh.faces(); ++f) {
      const std::size_t cell = mesh.cell_of(f);
      flux_.push_back(mesh.area[f][0] * v[0][cell] + mesh.area[f][1] * v[1][cell]);
      size_.push_back(mesh.size_of(f));
    }
  }

  FlowAtNode at_node(std::size_t node) {
    about_.faces_near(node, faces_);
    return at_boundary_[node] != 0 ? fitted<linear>(node) : fitted<quadratic>(node);
  }

 private:
  /// x, y, x^2, xy, y^2, x^3, x^2 y, x y^2, y^3 about a node, in its own unit of length.
  static std::array<double, quadratic> powers(const Vec<3>& from, double unit, const Vec<3>& to) {
    const double x = (to[0] - from[0]) / unit, y = (to[1] - from[1]) / unit;
    return {x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y};
  }

  /// The flux from the right to the left of a face is psi at its end less psi at its start, with v = (psi_y, -psi_x).
  template <int count>
  FlowAtNode fitted(std::size_t node) const {
    constexpr double held = 1e-9, softened = 0.2;
    double around = 0;
    for (const std::size_t cell : about_.of(node)) around += mesh_.volume[cell];
    const double unit = std::sqrt(2.3 * around / static_cast<double>(about_.of(node).size()));
    Eigen::Matrix<double, count, count> N = Eigen::Matrix<double, count, count>::Zero();
    Eigen::Vector<double, count> b = Eigen::Vector<double, count>::Zero(), row;
    for (const int face : faces_) {
      const auto f = at(face);
      const auto ends = mesh_.face_nodes(f);
      const auto first = powers(mesh_.x[node], unit, mesh_.x[at(ends[0])]),
                 last = powers(mesh_.x[node], unit, mesh_.x[at(ends[1])]);
      const double x = 0.5 * (first[0] + last[0]), y = 0.5 * (first[1] + last[1]), far = softened + x * x + y * y,
                   weight = unit / (size_[f] * (count == quadratic ? far * far : far));
      for (std::size_t k = 0; k < count; ++k) row[static_cast<Eigen::Index>(k)] = weight * (last[k] - first[k]);
      N.template selfadjointView<Eigen::Lower>().rankUpdate(row);
      b.noalias() += weight * flux_[f] / unit * row;
    }
    for (Eigen::Index k = 2; k < count; ++k) N(k, k) += held;
    const Eigen::Vector<double, count> c = N.ldlt().solve(b);
    return {{c[1], -c[0], 0}, {{{c[3] / unit, 2 * c[4] / unit}, {-2 * c[2] / unit, -c[3] / unit}}}};
  }

  const FlowMesh& mesh_;
  CellsAbout about_;
  std::vector<std::uint8_t> at_boundary_;  // of each node
  std::vector<double> flux_, size_;        // of each face, out of its first cell [volume/time]; its area
  std::vector<int> faces_;                 // about the node
};

}  // namespace

std::vector<FlowAtNode> flow_at_nodes(const FlowMesh& mesh, const FaceValues& v) {
  NodeFits fits(mesh, v);
  std::vector<FlowAtNode> flows;
  for (std::size_t node = 0; node < mesh.x.size(); ++node) flows.push_back(fits.at_node(node));
  return flows;
}

}  // namespace tether::coupled
