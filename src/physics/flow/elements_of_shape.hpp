// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "base/vec.hpp"
#include "grid/shapes.hpp"
#include "loops/elements.hpp"
#include "physics/flow/elements.hpp"
#include "physics/flow/kernels.hpp"
#include "physics/flow/unknowns.hpp"

namespace tether::fem {

/// Elements with velocities of shape V and pressures of shape P on the same corners; gradients of all points of
/// quadrature are kept.
template <class V, class P>
class FlowElementsOf final : public FlowElements {
 public:
  static constexpr int NV = V::nodes, NP = P::nodes, points = V::points;
  using Point = FlowPoint<NV, NP>;
  using Velocities = typename Point::Velocities;
  using Pressures = typename Point::Pressures;
  using Values = typename Point::Values;
  using Local = typename Point::Local;

  FlowElementsOf(const FlowUnknowns& unknowns, Team& team)
      : team_(team),
        unknowns_(unknowns),
        flow_(unknowns.flow),
        mesh_(flow_.mesh),
        corner_(pressure_nodes(flow_.element)) {
    for (int k = 0; k < points; ++k) {
      const auto s = V::place(k);
      values_[index(k)] = Eigen::Map<const Values>(V::values(s).data());
      pressure_values_[index(k)] = Eigen::Map<const Pressures>(P::values(s).data());
    }
    number_unknowns();
    for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
      for (int k = 0; k < points; ++k) add_point(e, k);
    }
    for (const FlowSide& side : flow_.sides) {
      if (side.boundary == Boundary::open) add_side_points<V>(mesh_, side.sides, open_);
      if (side.boundary == Boundary::inflow) add_side_points<V>(mesh_, side.sides, inflow_);
    }
    for (const ForceSide& force : flow_.forces) {
      corners_.emplace_back();
      for (CornerSide& side : corner_sides_of(flow_, force)) {
        std::vector<SidePoint<V>> at;
        add_side_points<V>(mesh_, side.nodes, at);
        corners_.back().push_back({std::move(side), std::move(at)});
      }
    }
  }

  FlowScale add_residual(const FlowMoment& m, std::span<double> f, std::span<double> g) const override {
    const FlowConstants c = constants(m);
    FlowScale scale;
    struct Residual {
      Local r;
      Size size;
    };
    compute_then_add<Residual>(
        team_, mesh_.element_count(),
        [&](std::size_t e, Residual& of) {
          const Velocities v0 = gathered(e, m.v0), v1 = gathered(e, m.v1);
          of = {Local::Zero(), {}};
          for_points(e, m, [&](Point& at) {
            at.evaluate(c, v0, v1, pressures(e, m.p));
            at.add_residual(c, of.r);
            of.size.add(at);
          });
        },
        [&](std::size_t e, const Residual& of) {
          add_scale(c, gathered(e, m.v1), of.r, of.size, scale);
          add_to_nodes(e, of.r, f, g);
        });
    for (const auto& at : open_) add_open_residual(c, m, at, f);
    return rooted(scale);
  }

  void add_tangent(const FlowMoment& m, const ClusterPattern& pattern, SparseMatrix& K) const override {
    const FlowConstants c = constants(m);
    using Matrix = typename Point::LocalMatrix;
    compute_then_add<Matrix>(
        team_, mesh_.element_count(),
        [&](std::size_t e, Matrix& k) {
          const Velocities v0 = gathered(e, m.v0), v1 = gathered(e, m.v1);
          k.setZero();
          for_points(e, m, [&](Point& at) {
            at.evaluate(c, v0, v1, pressures(e, m.p));
            at.add_tangent(c, k);
          });
        },
        [&](std::size_t e, const Matrix& k) {
          pattern.add(e, places_, numbers(e), std::span(k.data(), static_cast<std::size_t>(k.size())), K);
        });
    for (const auto& at : open_) add_open_tangent(c, at, pattern, K);
  }

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
  static std::size_t index(int k) { return static_cast<std::size_t>(k); }
  /// Node a of element e, of twins the one whose unknowns they share.
  std::size_t node(std::size_t e, int a) const {
    return static_cast<std::size_t>(flow_.twin[static_cast<std::size_t>(mesh_.element(e)[a])]);
  }
  FlowConstants constants(const FlowMoment& m) const {
    return {m.theta, m.rate, flow_.density, m.viscosity, flow_.stabilisation, m.linearisation == Linearisation::newton};
  }
  std::span<const int> numbers(std::size_t e) const {
    return std::span(numbers_).subspan(e * Point::size, Point::size);
  }

  void number_unknowns() {
    for (int a = 0; a < NV; ++a) places_[index(2 * a)] = places_[index(2 * a + 1)] = a;
    for (int q = 0; q < NP; ++q) places_[index(2 * NV + q)] = corner_[index(q)];
    numbers_.reserve(mesh_.element_count() * Point::size);
    for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
      for (int a = 0; a < NV; ++a) {
        for (std::size_t i = 0; i < 2; ++i) numbers_.push_back(unknowns_.velocity[2 * node(e, a) + i]);
      }
      for (int q = 0; q < NP; ++q) numbers_.push_back(unknowns_.pressure[node(e, corner_[index(q)])]);
    }
  }
  /// Returns, for the pressures that are unknown, the integral of what product(e, k) gives for an element's at a point.
  template <class Product>
  SparseMatrix pressure_matrix(const Product& product) const;

  void add_point(std::size_t e, int k) {
    const auto map = jacobian_at<V>(mesh_, e, V::place(k));
    const Velocities G = Eigen::Map<const Velocities>(map.gradients.data());
    gradients_.push_back(G);
    weights_.push_back(map.determinant * V::weight(k));
    const Eigen::Matrix2d to = to_reference(e, k);
    metrics_.push_back(to.transpose() * to);
  }
  /// ds/dx of the reference coordinates s at a point of quadrature.
  Eigen::Matrix2d to_reference(std::size_t e, int k) const {
    const auto S = V::gradients(V::place(k));
    Eigen::Matrix2d J = Eigen::Matrix2d::Zero();
    for (int a = 0; a < NV; ++a) {
      J += Eigen::Map<const Eigen::Vector2d>(&mesh_.x[2 * static_cast<std::size_t>(mesh_.element(e)[a])]) *
           Eigen::Map<const Eigen::RowVector2d>(&S[index(2 * a)]);
    }
    return J.inverse();
  }

  Velocities gathered(std::size_t e, std::span<const double> v) const {
    Velocities at;
    for (int a = 0; a < NV; ++a) at.col(a) = Eigen::Map<const Eigen::Vector2d>(&v[2 * node(e, a)]);
    return at;
  }
  Pressures pressures(std::size_t e, std::span<const double> p) const {
    Pressures at;
    for (int q = 0; q < NP; ++q) at[q] = p[node(e, corner_[index(q)])];
    return at;
  }
  /// Calls f with each point of quadrature of an element.
  template <class Function>
  void for_points(std::size_t e, const FlowMoment& m, const Function& f) const {
    for (int k = 0; k < points; ++k) {
      const std::size_t at = e * points + index(k);
      const Eigen::Vector2d b = Eigen::Map<const Eigen::Vector2d>(&m.acceleration[2 * at]);
      Point point{values_[index(k)],
                  gradients_[at],
                  pressure_values_[index(k)],
                  metrics_[at],
                  b,
                  weights_[at],
                  {},
                  {},
                  {},
                  {},
                  {},
                  {},
                  0,
                  0,
                  0,
                  0,
                  {}};
      f(point);
    }
  }

  void add_to_nodes(std::size_t e, const Local& r, std::span<double> f, std::span<double> g) const {
    for (int a = 0; a < NV; ++a) {
      const std::size_t n = node(e, a);
      f[2 * n] += r[2 * a], f[2 * n + 1] += r[2 * a + 1];
    }
    for (int q = 0; q < NP; ++q) g[node(e, corner_[index(q)])] += r[2 * NV + q];
  }

  /// Of an element: its volume, the largest slope of the velocity there, and how far the stabilisation carries forces.
  struct Size {
    double volume = 0, slope = 0, reach = 0;
    void add(const Point& at) {
      volume += at.weight, slope = std::max(slope, at.L.cwiseAbs().maxCoeff());
      reach = std::max(reach, at.tau * at.G.cwiseAbs().maxCoeff());
    }
  };
  /// Squares. Rounding is that of the momentum's rate, of velocities and of the forces that stabilise
  /// incompressibility.
  static void add_scale(const FlowConstants& c, const Velocities& v1, const Local& r, const Size& size,
                        FlowScale& scale) {
    const double fastest = v1.cwiseAbs().maxCoeff(), force = r.template head<2 * NV>().squaredNorm();
    const double inertia = c.rho * c.rate * fastest * size.volume / NV, flux = size.slope * size.volume / NP;
    scale.force += force;
    scale.flux += NP * flux * flux;
    scale.force_rounding += NV * inertia * inertia;
    scale.flux_rounding += NP * fastest * fastest * size.volume + size.reach * size.reach / (c.rho * c.rho) * force;
  }
  static FlowScale rooted(const FlowScale& squares) {
    constexpr double epsilon = 16 * std::numeric_limits<double>::epsilon();
    const double force = std::sqrt(squares.force);
    return {force, std::sqrt(squares.flux), epsilon * std::max(force, std::sqrt(squares.force_rounding)),
            epsilon * std::sqrt(squares.flux_rounding)};
  }

  /// The pressure of the fluid at rest beyond an open side [stress].
  double outside_pressure(const FlowMoment& m, const SidePoint<V>& at) const {
    double y = 0;
    for (int a = 0; a < NV; ++a) y += at.N[a] * mesh_.x[2 * static_cast<std::size_t>(mesh_.element(at.element)[a]) + 1];
    return flow_.density * m.gravity * (y - flow_.level);
  }
  /// -p n + mu dv/dn = -p_out n where a side is open: of the whole stress mu (grad v)^T n stays, which a parabolic
  /// profile has, too, and the pressure of the fluid outside, which keeps what is at rest at rest.
  void add_open_residual(const FlowConstants& c, const FlowMoment& m, const SidePoint<V>& at,
                         std::span<double> f) const {
    const Velocities vt = (1 - c.theta) * gathered(at.element, m.v0) + c.theta * gathered(at.element, m.v1);
    const Eigen::Vector2d traction = c.mu * (at.G * vt.transpose()) * at.normal - outside_pressure(m, at) * at.normal;
    for (int a = 0; a < NV; ++a) {
      const std::size_t n = node(at.element, a);
      f[2 * n] -= at.N[a] * traction[0], f[2 * n + 1] -= at.N[a] * traction[1];
    }
  }
  void add_open_tangent(const FlowConstants& c, const SidePoint<V>& at, const ClusterPattern& pattern,
                        SparseMatrix& K) const {
    typename Point::LocalMatrix k = Point::LocalMatrix::Zero();
    for (int a = 0; a < NV; ++a) {
      for (int b = 0; b < NV; ++b) {
        k.template block<2, 2>(2 * a, 2 * b) -= c.mu * c.theta * at.N[a] * at.G.col(b) * at.normal.transpose();
      }
    }
    pattern.add(at.element, places_, numbers(at.element), std::span(k.data(), static_cast<std::size_t>(k.size())), K);
  }

  Team& team_;
  const FlowUnknowns& unknowns_;
  const Flow& flow_;
  const Mesh& mesh_;
  std::span<const int> corner_;
  std::array<Values, index_count<points>> values_;
  std::array<Pressures, index_count<points>> pressure_values_;
  std::array<int, index_count<Point::size>> places_;  // node within the element of each local unknown
  std::vector<int> numbers_;                          // unknown of each local one, element by element
  std::vector<Velocities> gradients_;
  std::vector<double> weights_;
  std::vector<Eigen::Matrix2d> metrics_;
  std::vector<SidePoint<V>> open_, inflow_;
  /// An element side at the end of a force side, and its points of quadrature.
  struct Corner {
    CornerSide side;
    std::vector<SidePoint<V>> points;
  };
  std::vector<std::vector<Corner>> corners_;  // of each force side
};

}  // namespace tether::fem
