// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solids/side_pressure.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>

#include "grid/side_tangents.hpp"

namespace tether::fem {
namespace {

/// A part of a force between two shapes: what the shape that lies `at` of the way counts.
struct Share {
  double at, weight;
};

/// Simpson's rule, the middle, or the end.
std::vector<Share> shares_of(StressAt at) {
  if (at == StressAt::gradient) return {{0, 1.0 / 6}, {0.5, 4.0 / 6}, {1, 1.0 / 6}};
  return {{at == StressAt::middle ? 0.5 : 1.0, 1}};
}

std::vector<double> between(std::span<const double> q0, std::span<const double> q1, double at) {
  std::vector<double> q(q0.size());
  for (std::size_t k = 0; k < q.size(); ++k) q[k] = (1 - at) * q0[k] + at * q1[k];
  return q;
}

/// The outward normal times the area over that of the reference side, and its derivative by the place of a node whose
/// function has the slopes g.
inline Eigen::Vector2d normal_of(const Eigen::Matrix<double, 2, 1>& t) { return {t[1], -t[0]}; }
inline Eigen::Vector3d normal_of(const Eigen::Matrix<double, 3, 2>& t) {
  return Eigen::Vector3d(t.col(0)).cross(Eigen::Vector3d(t.col(1)));
}
inline Eigen::Matrix2d normal_slope(const Eigen::Matrix<double, 2, 1>&, const double* g) {
  return (Eigen::Matrix2d() << 0, g[0], -g[0], 0).finished();
}
inline Eigen::Matrix3d normal_slope(const Eigen::Matrix<double, 3, 2>& t, const double* g) {
  const Eigen::Vector3d c = g[1] * t.col(0) - g[0] * t.col(1);  // dn = c x dx
  return (Eigen::Matrix3d() << 0, -c[2], c[1], c[2], 0, -c[0], -c[1], c[0], 0).finished();
}

}  // namespace

SidePressure::SidePressure(const Mesh& mesh, const Sides& sides)
    : mesh_(mesh), sides_(sides), element_(elements_of_sides(mesh, sides)) {
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const int* nodes = mesh.element(element_[k / per_side()]);
    in_element_.push_back(static_cast<int>(std::find(nodes, nodes + node_count_of(mesh.kind), sides_[k]) - nodes));
  }
}

template <class Side>
void SidePressure::add_side_forces(std::size_t s, std::span<const double> q, double pressure,
                                   std::span<double> f) const {
  const int* nodes = &sides_[s * Side::nodes];
  for (int k = 0; k < Side::mass_points; ++k) {
    const auto place = Side::mass_place(k);
    const auto N = Side::values(place);
    const auto force =
        (-pressure * Side::mass_weight(k) * normal_of(tangents_at<Side>(nodes, q, Side::gradients(place)))).eval();
    for (int a = 0; a < Side::nodes; ++a) {
      for (int i = 0; i <= Side::dim; ++i)
        f[static_cast<std::size_t>(nodes[a] * (Side::dim + 1) + i)] += N[at(a)] * force[i];
    }
  }
}

void SidePressure::add_forces(StressAt at, std::span<const double> q0, std::span<const double> q1, double pressure,
                              std::span<double> f) const {
  for (const Share& share : shares_of(at)) {
    const std::vector<double> q = between(q0, q1, share.at);
    with_shapes(mesh_.kind, [&](auto shapes) {
      for (std::size_t s = 0; s < element_.size(); ++s)
        add_side_forces<typename decltype(shapes)::Side>(s, q, share.weight * pressure, f);
    });
  }
}

template <class Side>
void SidePressure::add_side_tangent(std::size_t s, std::span<const double> q, double factor,
                                    std::span<double> matrix) const {
  constexpr int dim = Side::dim + 1;
  const int* nodes = &sides_[s * Side::nodes];
  const auto unknowns = static_cast<std::size_t>(dim * node_count_of(mesh_.kind));
  for (int k = 0; k < Side::mass_points; ++k) {
    const auto place = Side::mass_place(k);
    const auto N = Side::values(place);
    const auto G = Side::gradients(place);
    const Tangents<Side> t = tangents_at<Side>(nodes, q, G);
    for (int b = 0; b < Side::nodes; ++b) {
      const auto slope = (-factor * Side::mass_weight(k) * normal_slope(t, &G[at(b * Side::dim)])).eval();
      for (int a = 0; a < Side::nodes; ++a) {
        const auto row = static_cast<std::size_t>(dim * in_element_[s * Side::nodes + at(a)]);
        const auto column = static_cast<std::size_t>(dim * in_element_[s * Side::nodes + at(b)]);
        for (std::size_t i = 0; i < dim; ++i) {
          for (std::size_t j = 0; j < dim; ++j)
            matrix[(row + i) * unknowns + column + j] += N[at(a)] * slope(static_cast<int>(i), static_cast<int>(j));
        }
      }
    }
  }
}

void SidePressure::add_tangent(StressAt at, std::span<const double> q0, std::span<const double> q1, double factor,
                               const NodalPattern& pattern, SparseMatrix& K) const {
  const auto unknowns = static_cast<std::size_t>(mesh_.dim() * node_count_of(mesh_.kind));
  for (const Share& share : shares_of(at)) {
    if (share.at == 0) continue;
    const std::vector<double> q = between(q0, q1, share.at);
    with_shapes(mesh_.kind, [&](auto shapes) {
      std::vector<double> matrix(unknowns * unknowns);
      for (std::size_t s = 0; s < element_.size(); ++s) {
        std::fill(matrix.begin(), matrix.end(), 0.0);
        add_side_tangent<typename decltype(shapes)::Side>(s, q, share.weight * share.at * factor, matrix);
        pattern.add(element_[s], matrix, K);
      }
    });
  }
}

}  // namespace tether::fem
