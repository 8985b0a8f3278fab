// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "base/vec.hpp"
#include "physics/flow/elements_of_shape.hpp"
#include "physics/flow/unknowns.hpp"

namespace tether::fem {

// What the elements of a flow say of it beside their residual: integrals over the mesh, fields at its nodes, and
// matrices of its pressures.

template <class V, class P>
std::vector<double> FlowElementsOf<V, P>::accelerations(double gravity, double time) const {
  std::vector<double> b(2 * weights_.size(), 0.0);
  for (std::size_t at = 0; at < weights_.size(); ++at) {
    const std::size_t e = at / points;
    Eigen::Vector2d x = Eigen::Vector2d::Zero();
    for (int a = 0; a < NV; ++a)
      x += values_[at % points][a] *
           Eigen::Map<const Eigen::Vector2d>(&mesh_.x[2 * static_cast<std::size_t>(mesh_.element(e)[a])]);
    const auto given = flow_.acceleration.at(x[0], x[1], time);
    b[2 * at] = given[0], b[2 * at + 1] = given[1] + gravity;
  }
  return b;
}

template <class V, class P>
double FlowElementsOf<V, P>::kinetic_energy(std::span<const double> v) const {
  double energy = 0;
  for (std::size_t at = 0; at < weights_.size(); ++at)
    energy += 0.5 * flow_.density * weights_[at] * (gathered(at / points, v) * values_[at % points]).squaredNorm();
  return energy;
}

template <class V, class P>
double FlowElementsOf<V, P>::pressure_energy(std::span<const double> p) const {
  double energy = 0;
  for (std::size_t at = 0; at < weights_.size(); ++at)
    energy += weights_[at] * std::abs(pressures(at / points, p).dot(pressure_values_[at % points]));
  return energy;
}

template <class V, class P>
std::array<double, 3> FlowElementsOf<V, P>::momentum(std::span<const double> v) const {
  std::array<double, 3> sum{};
  for (std::size_t at = 0; at < weights_.size(); ++at) {
    const Eigen::Vector2d u = gathered(at / points, v) * values_[at % points];
    const double mass = flow_.density * weights_[at];
    sum[0] += mass, sum[1] += mass * u[0], sum[2] += mass * u[1];
  }
  return sum;
}

template <class V, class P>
FlowPower FlowElementsOf<V, P>::power(const FlowMoment& m) const {
  const FlowConstants c = constants(m);
  FlowPower power;
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    const Velocities v0 = gathered(e, m.v0), v1 = gathered(e, m.v1);
    for_points(e, m, [&](Point& at) {
      at.evaluate(c, v0, v1, pressures(e, m.p));
      power.dissipated += at.weight * 0.5 * c.mu * (at.L + at.L.transpose()).squaredNorm();
      power.body += at.weight * c.rho * at.b.dot(at.v);
      power.convected += at.weight * c.rho * at.convection.dot(at.v);
      if constexpr (Point::stabilised)
        power.stabilised +=
            at.weight * (at.tau * at.convection.dot(at.residual) + (at.tau_L * at.divergence - at.p) * at.L.trace());
      else
        power.expansion -= at.weight * at.p * at.L.trace();
    });
  }
  const auto velocity = [&](const SidePoint<V>& at) {
    return Velocities((1 - c.theta) * gathered(at.element, m.v0) + c.theta * gathered(at.element, m.v1));
  };
  const auto carried = [&](const SidePoint<V>& at) {
    const Eigen::Vector2d v = velocity(at) * at.N;
    return 0.5 * c.rho * v.squaredNorm() * v.dot(at.normal);
  };
  for (const auto& at : open_) power.carried_by_open += carried(at);
  for (const auto& at : inflow_) power.carried_by_inflows += carried(at);
  for (const auto& at : open_) {
    const Velocities vt = velocity(at);
    const Eigen::Vector2d traction = c.mu * (at.G * vt.transpose()) * at.normal - outside_pressure(m, at) * at.normal;
    power.open_traction += (vt * at.N).dot(traction);
  }
  return power;
}

/// <N_A, sigma n> over the element sides at the ends: half of it, of the side's own with the other sign. Where they
/// slip, what acts along them is known to be nothing.
template <class V, class P>
std::vector<NodeForce> FlowElementsOf<V, P>::corner_forces(const FlowMoment& m, std::size_t k) const {
  const FlowConstants c = constants(m);
  std::vector<NodeForce> forces;
  for (const Corner& corner : corners_[k]) {
    for (const SidePoint<V>& at : corner.points) {
      const Velocities vt = (1 - c.theta) * gathered(at.element, m.v0) + c.theta * gathered(at.element, m.v1);
      const Eigen::Matrix2d L = vt * at.G.transpose();
      const double p = pressures(at.element, m.p).dot(Eigen::Map<const Pressures>(P::values(at.place).data()));
      Eigen::Vector2d traction = c.mu * (L + L.transpose()) * at.normal - p * at.normal;
      if (corner.side.slip) traction = at.normal * at.normal.dot(traction) / at.normal.squaredNorm();
      for (const int a : corner.side.shared) {
        const int n = corner.side.nodes[static_cast<std::size_t>(a)];
        const int* nodes = mesh_.element(at.element);
        const double N = at.N[std::find(nodes, nodes + NV, n) - nodes];
        const double part = corner.side.own ? -0.5 * N : 0.5 * N;
        forces.push_back({static_cast<std::size_t>(n), {part * traction[0], part * traction[1]}});
      }
    }
  }
  return forces;
}

/// sigma of (38): xx, yy, xy.
template <class V, class P>
std::array<double, 3> FlowElementsOf<V, P>::stress_at(const FlowMoment& m, std::size_t e, const Vec<2>& s) const {
  const auto map = jacobian_at<V>(mesh_, e, s);
  const Velocities vt = (1 - m.theta) * gathered(e, m.v0) + m.theta * gathered(e, m.v1);
  const Eigen::Matrix2d L = vt * Eigen::Map<const Velocities>(map.gradients.data()).transpose();
  const double p = pressures(e, m.p).dot(Eigen::Map<const Pressures>(P::values(s).data()));
  return {2 * m.viscosity * L(0, 0) - p, 2 * m.viscosity * L(1, 1) - p, m.viscosity * (L(0, 1) + L(1, 0))};
}

template <class V, class P>
std::vector<double> FlowElementsOf<V, P>::vorticity(std::span<const double> v) const {
  std::vector<double> sum(mesh_.node_count(), 0.0), volume(mesh_.node_count(), 0.0);
  for (std::size_t at = 0; at < weights_.size(); ++at) {
    const std::size_t e = at / points;
    const Eigen::Matrix2d L = gathered(e, v) * gradients_[at].transpose();
    for (int a = 0; a < NV; ++a) {
      const double part = weights_[at] * std::abs(values_[at % points][a]);
      sum[node(e, a)] += part * (L(1, 0) - L(0, 1)), volume[node(e, a)] += part;
    }
  }
  for (std::size_t n = 0; n < sum.size(); ++n) sum[n] /= std::max(volume[n], std::numeric_limits<double>::min());
  unknowns_.copy_to_twins(sum, 1);
  return sum;
}

template <class V, class P>
SparseMatrix FlowElementsOf<V, P>::laplacian(std::span<const int> unknown) const {
  std::vector<int> unknowns;
  for (const int node : mesh_.nodes) unknowns.push_back(unknown[static_cast<std::size_t>(node)]);
  const std::size_t count = static_cast<std::size_t>(*std::max_element(unknown.begin(), unknown.end())) + 1;
  const NodalPattern pattern(1, count, unknowns, NV);
  SparseMatrix A = pattern.matrix();
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    Eigen::Matrix<double, NV, NV, Eigen::RowMajor> k = Eigen::Matrix<double, NV, NV>::Zero();
    for (int q = 0; q < points; ++q) {
      const Velocities& G = gradients_[e * points + index(q)];
      k += weights_[e * points + index(q)] * (G.transpose() * G);
    }
    pattern.add(e, std::span(k.data(), index_count<NV * NV>), A);
  }
  return A;
}

template <class V, class P>
std::vector<double> FlowElementsOf<V, P>::stream_source(std::span<const double> v) const {
  std::vector<double> source(mesh_.node_count(), 0.0);
  for (std::size_t at = 0; at < weights_.size(); ++at) {
    const std::size_t e = at / points;
    const Eigen::Vector2d u = gathered(e, v) * values_[at % points];
    for (int a = 0; a < NV; ++a) {
      const auto g = gradients_[at].col(a);
      source[static_cast<std::size_t>(mesh_.element(e)[a])] += weights_[at] * (g[1] * u[0] - g[0] * u[1]);
    }
  }
  return source;
}

template <class V, class P>
std::vector<double> FlowElementsOf<V, P>::pressure_at_nodes(std::span<const double> p) const {
  std::vector<double> all(mesh_.node_count(), 0.0);
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    const Pressures at = pressures(e, p);
    constexpr int line = NV == 4 ? 2 : 3;
    for (int a = 0; a < NV; ++a) {
      const Vec<2> s{2.0 * (a % line) / (line - 1) - 1, 2.0 * (a / line) / (line - 1) - 1};
      all[static_cast<std::size_t>(mesh_.element(e)[a])] = at.dot(Eigen::Map<const Pressures>(P::values(s).data()));
    }
  }
  return all;
}

template <class V, class P>
template <class Product>
SparseMatrix FlowElementsOf<V, P>::pressure_matrix(const Product& product) const {
  std::vector<int> first{0};  // pressures that are unknown, in the order of their nodes and so of the unknowns
  for (std::size_t n = 0; n < mesh_.node_count(); ++n)
    first.push_back(first.back() + (static_cast<std::size_t>(flow_.twin[n]) == n && unknowns_.pressure[n] >= 0));
  const ClusterPattern pattern(first, clusters_of(flow_));
  SparseMatrix A = pattern.matrix();
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    Eigen::Matrix<double, NP, NP, Eigen::RowMajor> k = Eigen::Matrix<double, NP, NP>::Zero();
    for (int at = 0; at < points; ++at) k += weights_[e * points + index(at)] * product(e, at);
    std::array<int, index_count<NP>> number;
    for (int q = 0; q < NP; ++q) {
      const std::size_t n = node(e, corner_[index(q)]);
      number[index(q)] = unknowns_.pressure[n] < 0 ? -1 : first[n];
    }
    pattern.add(e, corner_, number, std::span(k.data(), index_count<NP * NP>), A);
  }
  return A;
}

template <class V, class P>
SparseMatrix FlowElementsOf<V, P>::pressure_mass() const {
  using Matrix = Eigen::Matrix<double, NP, NP>;
  return pressure_matrix([&](std::size_t, int k) -> Matrix {
    return pressure_values_[index(k)] * pressure_values_[index(k)].transpose();
  });
}

template <class V, class P>
SparseMatrix FlowElementsOf<V, P>::pressure_laplacian() const {
  using Matrix = Eigen::Matrix<double, NP, NP>;
  SparseMatrix A = pressure_matrix([&](std::size_t e, int k) -> Matrix {
    const auto S = P::gradients(V::place(k));
    const Eigen::Matrix<double, 2, NP> G =
        to_reference(e, k).transpose() * Eigen::Map<const Eigen::Matrix<double, 2, NP>>(S.data());
    return G.transpose() * G;
  });
  const auto twin = [&](int n) { return static_cast<std::size_t>(flow_.twin[static_cast<std::size_t>(n)]); };
  std::vector<std::uint8_t> on_open(mesh_.node_count(), 0), held;
  for (const FlowSide& side : flow_.sides) {
    for (const int n : side.sides) on_open[twin(n)] |= side.boundary == Boundary::open;
  }
  for (std::size_t n = 0; n < mesh_.node_count(); ++n) {
    if (static_cast<std::size_t>(flow_.twin[n]) == n && unknowns_.pressure[n] >= 0) held.push_back(on_open[n]);
  }
  hold(A, held, 1);
  return A;
}

template <class V, class P>
double FlowElementsOf<V, P>::mean_lsic(const FlowMoment& m) const {
  if constexpr (!Point::stabilised) return 0;
  const FlowConstants c = constants(m);
  double sum = 0, volume = 0;
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    const Velocities v0 = gathered(e, m.v0), v1 = gathered(e, m.v1);
    for_points(e, m, [&](Point& at) {
      at.evaluate(c, v0, v1, pressures(e, m.p));
      sum += at.weight * at.tau_L, volume += at.weight;
    });
  }
  return sum / volume;
}

}  // namespace tether::fem
