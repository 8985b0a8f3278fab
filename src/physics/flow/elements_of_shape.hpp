// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "physics/flow/elements.hpp"
#include "physics/flow/kernels.hpp"
#include "physics/flow/plane_elements.hpp"
#include "physics/flow/side_points.hpp"
#include "physics/flow/unknowns.hpp"

namespace tether::fem {

/// Elements whose velocities have the mesh's shape and whose pressures are bilinear on the same corners; gradients of
/// all points of quadrature are kept.
class FlowElementsOfShape final : public FlowElements {
 public:
  FlowElementsOfShape(const FlowUnknowns& unknowns, Team& team);

  FlowScale add_residual(const FlowMoment& m, std::span<double> f, std::span<double> g) const override;
  void add_tangent(const FlowMoment& m, const ClusterPattern& pattern, SparseMatrix& K) const override;
  std::vector<double> accelerations(double gravity, double time) const override;
  double kinetic_energy(std::span<const double> v) const override;
  double pressure_energy(std::span<const double> p) const override;
  std::array<double, 3> momentum(std::span<const double> v) const override;
  FlowPower power(const FlowMoment& m) const override;
  std::vector<NodeForce> corner_forces(const FlowMoment& m, std::size_t k) const override;
  std::array<double, 3> stress_at(const FlowMoment& m, std::size_t e, const Vec<2>& s) const override;
  std::vector<double> vorticity(std::span<const double> v) const override;
  SparseMatrix laplacian(std::span<const int> unknown) const override;
  std::vector<double> stream_source(std::span<const double> v) const override;
  std::vector<double> pressure_at_nodes(std::span<const double> p) const override;
  SparseMatrix pressure_mass() const override;
  SparseMatrix pressure_laplacian() const override;
  double mean_lsic(const FlowMoment& m) const override;

 private:
  FlowConstants constants(const FlowMoment& m) const;
  void number_unknowns();
  void add_points(std::size_t e);

  /// Node a of element e, of twins the one whose unknowns they share.
  std::size_t node(std::size_t e, std::size_t a) const {
    return static_cast<std::size_t>(flow_.twin[static_cast<std::size_t>(mesh_.element(e)[a])]);
  }
  std::size_t pressure_node(std::size_t e, std::size_t q) const {
    return node(e, static_cast<std::size_t>(corner_[q]));
  }
  std::span<const int> numbers(std::size_t e) const {
    return std::span(numbers_).subspan(e * places_.size(), places_.size());
  }
  const PlaneNumbers& values(std::size_t k) const { return shape_.points[k].N; }
  std::span<const Vec<2>> gradients(std::size_t at) const { return std::span(gradients_).subspan(at * nodes_, nodes_); }

  PlaneVectors gathered(std::size_t e, std::span<const double> v) const {
    PlaneVectors at;
    for (std::size_t a = 0; a < nodes_; ++a) at[a] = {v[2 * node(e, a)], v[2 * node(e, a) + 1]};
    return at;
  }
  Pressures pressures(std::size_t e, std::span<const double> p) const {
    Pressures at;
    for (std::size_t q = 0; q < pressures_of_element; ++q) at[q] = p[pressure_node(e, q)];
    return at;
  }
  NodalFlow nodal_flow(std::size_t e, const FlowMoment& m) const {
    NodalFlow of{gathered(e, m.v0), gathered(e, m.v1), {}, pressures(e, m.p)};
    for (std::size_t a = 0; a < nodes_; ++a) {
      for (std::size_t i = 0; i < 2; ++i) of.vt[a][i] = (1 - m.theta) * of.v0[a][i] + m.theta * of.v1[a][i];
    }
    return of;
  }
  /// Calls f with each point of quadrature of an element.
  template <class Function>
  void for_points(std::size_t e, const FlowMoment& m, const Function& f) const {
    const std::size_t points = shape_.points.size();
    for (std::size_t k = 0; k < points; ++k) {
      const std::size_t at = e * points + k;
      const Vec<2> b{m.acceleration[2 * at], m.acceleration[2 * at + 1]};
      FlowPoint point{
          std::span(values(k)).first(nodes_), gradients(at), pressure_values_[k], metrics_[at], b, weights_[at]};
      f(point);
    }
  }
  /// Calls f with each point of quadrature of all elements: its element, its number there, that among all, and the
  /// velocities of the element's nodes.
  template <class Function>
  void for_all_points(std::span<const double> v, const Function& f) const {
    for (std::size_t e = 0, at = 0; e < mesh_.element_count(); ++e) {
      const PlaneVectors of_nodes = gathered(e, v);
      for (std::size_t k = 0; k < shape_.points.size(); ++k) f(e, k, at++, of_nodes);
    }
  }

  double outside_pressure(const FlowMoment& m, const SidePoint& on) const;
  Vec<2> open_traction(const FlowConstants& c, const FlowMoment& m, const SidePoint& on) const;
  void add_open_residual(const FlowConstants& c, const FlowMoment& m, const SidePoint& on, std::span<double> f) const;
  void add_open_tangent(const FlowConstants& c, const SidePoint& on, const ClusterPattern& pattern,
                        SparseMatrix& K) const;
  /// Returns, for the pressures that are unknown, the integral of the products of vectors(e, k), which an element's
  /// pressures have at a point.
  template <class Vectors>
  SparseMatrix pressure_matrix(const Vectors& vectors) const;

  Team& team_;
  const FlowUnknowns& unknowns_;
  const Flow& flow_;
  const Mesh& mesh_;
  const PlaneShape shape_;
  const std::size_t nodes_;  // of an element
  std::span<const int> corner_;
  std::vector<Pressures> pressure_values_;  // functions of the pressures at the points of quadrature
  std::vector<int> places_;                 // node within the element of each local unknown
  std::vector<int> numbers_;                // unknown of each local one, element by element
  std::vector<Vec<2>> gradients_;           // a node of each point
  std::vector<double> weights_;
  std::vector<PlaneMatrix> metrics_;
  std::vector<SidePoint> open_, inflow_;
  /// An element side at the end of a force side, and its points of quadrature.
  struct Corner {
    CornerSide side;
    std::vector<SidePoint> points;
  };
  std::vector<std::vector<Corner>> corners_;  // of each force side
};

}  // namespace tether::fem
