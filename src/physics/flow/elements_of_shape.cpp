// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/elements_of_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "loops/elements.hpp"

namespace tether::fem {
namespace {

double size_of(const Vec<2>& v) { return std::max(std::abs(v[0]), std::abs(v[1])); }

/// Of an element: its volume, the largest velocity of a node and slope of the velocity there, and how far the
/// stabilisation carries forces.
struct FlowSize {
  double volume = 0, fastest = 0, slope = 0, reach = 0;
  void add(const FlowPoint& at) {
    volume += at.weight, slope = std::max({slope, size_of(at.L[0]), size_of(at.L[1])});
    for (const Vec<2>& G : at.G) reach = std::max(reach, at.tau * size_of(G));
  }
};

/// Squares. Rounding is that of the momentum's rate, of velocities and of the forces that stabilise incompressibility.
void add_scale(const FlowConstants& c, std::size_t nodes, const UnknownNumbers& r, const FlowSize& size,
               FlowScale& scale) {
  constexpr double NP = pressures_of_element;
  const auto NV = static_cast<double>(nodes);
  double force = 0;
  for (std::size_t k = 0; k < 2 * nodes; ++k) force += r[k] * r[k];
  const double inertia = c.rho * c.rate * size.fastest * size.volume / NV, flux = size.slope * size.volume / NP;
  scale.force += force;
  scale.flux += NP * flux * flux;
  scale.force_rounding += NV * inertia * inertia;
  scale.flux_rounding +=
      NP * size.fastest * size.fastest * size.volume + size.reach * size.reach / (c.rho * c.rho) * force;
}

FlowScale rooted(const FlowScale& squares) {
  constexpr double epsilon = 16 * std::numeric_limits<double>::epsilon();
  const double force = std::sqrt(squares.force);
  return {force, std::sqrt(squares.flux), epsilon * std::max(force, std::sqrt(squares.force_rounding)),
          epsilon * std::sqrt(squares.flux_rounding)};
}

}  // namespace

FlowElementsOfShape::FlowElementsOfShape(const FlowUnknowns& unknowns, Team& team)
    : team_(team),
      unknowns_(unknowns),
      flow_(unknowns.flow),
      mesh_(flow_.mesh),
      shape_(plane_shape(mesh_.kind)),
      nodes_(shape_.nodes),
      corner_(pressure_nodes(flow_.element)) {
  for (const PlanePoint& at : shape_.points) pressure_values_.push_back(PressureShape::values(at.s));
  number_unknowns();
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) add_points(e);
  for (const FlowSide& side : flow_.sides) {
    if (side.boundary == Boundary::open) add_side_points(mesh_, side.sides, open_);
    if (side.boundary == Boundary::inflow) add_side_points(mesh_, side.sides, inflow_);
  }
  for (const ForceSide& force : flow_.forces) {
    corners_.emplace_back();
    for (CornerSide& side : corner_sides_of(flow_, force)) {
      std::vector<SidePoint> points;
      add_side_points(mesh_, side.nodes, points);
      corners_.back().push_back({std::move(side), std::move(points)});
    }
  }
}

void FlowElementsOfShape::number_unknowns() {
  for (int a = 0; a < static_cast<int>(nodes_); ++a) places_.insert(places_.end(), 2, a);
  places_.insert(places_.end(), corner_.begin(), corner_.end());
  numbers_.reserve(mesh_.element_count() * places_.size());
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    for (std::size_t a = 0; a < nodes_; ++a) {
      for (std::size_t i = 0; i < 2; ++i) numbers_.push_back(unknowns_.velocity[2 * node(e, a) + i]);
    }
    for (std::size_t q = 0; q < pressures_of_element; ++q) numbers_.push_back(unknowns_.pressure[pressure_node(e, q)]);
  }
}

void FlowElementsOfShape::add_points(std::size_t e) {
  const PlaneVectors places = fem::gathered(mesh_, e, mesh_.x);
  for (const PlanePoint& at : shape_.points) {
    const PlaneMap map = plane_map(nodes_, places, at);
    gradients_.insert(gradients_.end(), map.gradients.begin(),
                      map.gradients.begin() + static_cast<std::ptrdiff_t>(nodes_));
    weights_.push_back(map.determinant * at.weight);
    const auto& [s, t] = map.to_reference;  // ds/dx of both coordinates
    const double across = s[0] * s[1] + t[0] * t[1];
    metrics_.push_back({{{s[0] * s[0] + t[0] * t[0], across}, {across, s[1] * s[1] + t[1] * t[1]}}});
  }
}

FlowConstants FlowElementsOfShape::constants(const FlowMoment& m) const {
  return {m.theta,
          m.rate,
          flow_.density,
          m.viscosity,
          flow_.stabilisation,
          m.linearisation == Linearisation::newton,
          flow_.element == FlowElement::q1q1};
}

FlowScale FlowElementsOfShape::add_residual(const FlowMoment& m, std::span<double> f, std::span<double> g) const {
  const FlowConstants c = constants(m);
  FlowScale scale;
  struct Residual {
    UnknownNumbers r;
    FlowSize size;
  };
  compute_then_add<Residual>(
      team_, mesh_.element_count(),
      [&](std::size_t e, Residual& of) {
        of = {};
        const NodalFlow there = nodal_flow(e, m);
        for (std::size_t a = 0; a < nodes_; ++a) of.size.fastest = std::max(of.size.fastest, size_of(there.v1[a]));
        for_points(e, m, [&](FlowPoint& at) {
          at.evaluate(c, there);
          at.add_residual(c, of.r);
          of.size.add(at);
        });
      },
      [&](std::size_t e, const Residual& of) {
        add_scale(c, nodes_, of.r, of.size, scale);
        for (std::size_t a = 0; a < nodes_; ++a) {
          for (std::size_t i = 0; i < 2; ++i) f[2 * node(e, a) + i] += of.r[2 * a + i];
        }
        for (std::size_t q = 0; q < pressures_of_element; ++q) g[pressure_node(e, q)] += of.r[2 * nodes_ + q];
      });
  for (const SidePoint& on : open_) add_open_residual(c, m, on, f);
  return rooted(scale);
}

void FlowElementsOfShape::add_tangent(const FlowMoment& m, const ClusterPattern& pattern, SparseMatrix& K) const {
  const FlowConstants c = constants(m);
  compute_then_add<UnknownMatrix>(
      team_, mesh_.element_count(),
      [&](std::size_t e, UnknownMatrix& k) {
        k.reset(places_.size());
        const NodalFlow there = nodal_flow(e, m);
        for_points(e, m, [&](FlowPoint& at) {
          at.evaluate(c, there);
          at.add_tangent(c, k);
        });
      },
      [&](std::size_t e, const UnknownMatrix& k) { pattern.add(e, places_, numbers(e), k.numbers(), K); });
  for (const SidePoint& on : open_) add_open_tangent(c, on, pattern, K);
}

/// The pressure of the fluid at rest beyond an open side [stress].
double FlowElementsOfShape::outside_pressure(const FlowMoment& m, const SidePoint& on) const {
  double y = 0;
  for (std::size_t a = 0; a < nodes_; ++a)
    y += on.at.N[a] * mesh_.x[2 * static_cast<std::size_t>(mesh_.element(on.element)[a]) + 1];
  return flow_.density * m.gravity * (y - flow_.level);
}

/// -p n + mu dv/dn = -p_out n where a side is open: of the whole stress mu (grad v)^T n stays, which a parabolic
/// profile has, too, and the pressure of the fluid outside, which keeps what is at rest at rest.
Vec<2> FlowElementsOfShape::open_traction(const FlowConstants& c, const FlowMoment& m, const SidePoint& on) const {
  const PlaneMatrix L = slopes(nodes_, nodal_flow(on.element, m).vt, on.G);
  const Vec<2>& n = on.normal;
  const double outside = outside_pressure(m, on);
  return {c.mu * (L[0][0] * n[0] + L[1][0] * n[1]) - outside * n[0],
          c.mu * (L[0][1] * n[0] + L[1][1] * n[1]) - outside * n[1]};
}
void FlowElementsOfShape::add_open_residual(const FlowConstants& c, const FlowMoment& m, const SidePoint& on,
                                            std::span<double> f) const {
  const Vec<2> traction = open_traction(c, m, on);
  for (std::size_t a = 0; a < nodes_; ++a) {
    const std::size_t n = node(on.element, a);
    f[2 * n] -= on.at.N[a] * traction[0], f[2 * n + 1] -= on.at.N[a] * traction[1];
  }
}
void FlowElementsOfShape::add_open_tangent(const FlowConstants& c, const SidePoint& on, const ClusterPattern& pattern,
                                           SparseMatrix& K) const {
  UnknownMatrix k;
  k.reset(places_.size());
  for (std::size_t a = 0; a < nodes_; ++a) {
    for (std::size_t b = 0; b < nodes_; ++b) {
      for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t j = 0; j < 2; ++j)
          k(2 * a + i, 2 * b + j) -= c.mu * c.theta * on.at.N[a] * on.G[b][i] * on.normal[j];
      }
    }
  }
  pattern.add(on.element, places_, numbers(on.element), k.numbers(), K);
}

}  // namespace tether::fem
