// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "physics/flow/elements_of_shape.hpp"

namespace tether::fem {
namespace {

using PressureVectors = std::array<Vec<2>, pressures_of_element>;

double square_of(const Vec<2>& v) { return dot(v, v); }
double pressure_at(const Pressures& functions, const Pressures& p) {
  double sum = 0;
  for (std::size_t q = 0; q < pressures_of_element; ++q) sum += functions[q] * p[q];
  return sum;
}

}  // namespace

// What the elements of a flow say of it beside their residual: integrals over the mesh, fields at its nodes, and
// matrices of its pressures.

std::vector<double> FlowElementsOfShape::accelerations(double gravity, double time) const {
  std::vector<double> b(2 * weights_.size(), 0.0);
  for (std::size_t e = 0, at = 0; e < mesh_.element_count(); ++e) {
    const PlaneVectors places = fem::gathered(mesh_, e, mesh_.x);
    for (std::size_t k = 0; k < shape_.points.size(); ++k, ++at) {
      const Vec<2> x = mean(nodes_, values(k), places);
      const auto given = flow_.acceleration.at(x[0], x[1], time);
      b[2 * at] = given[0], b[2 * at + 1] = given[1] + gravity;
    }
  }
  return b;
}

double FlowElementsOfShape::kinetic_energy(std::span<const double> v) const {
  double energy = 0;
  for_all_points(v, [&](std::size_t, std::size_t k, std::size_t at, const PlaneVectors& of_nodes) {
    energy += 0.5 * flow_.density * weights_[at] * square_of(mean(nodes_, values(k), of_nodes));
  });
  return energy;
}

double FlowElementsOfShape::pressure_energy(std::span<const double> p) const {
  double energy = 0;
  for (std::size_t e = 0, at = 0; e < mesh_.element_count(); ++e) {
    const Pressures of_nodes = pressures(e, p);
    for (const Pressures& P : pressure_values_) energy += weights_[at++] * std::abs(pressure_at(P, of_nodes));
  }
  return energy;
}

std::array<double, 3> FlowElementsOfShape::momentum(std::span<const double> v) const {
  std::array<double, 3> sum{};
  for_all_points(v, [&](std::size_t, std::size_t k, std::size_t at, const PlaneVectors& of_nodes) {
    const Vec<2> u = mean(nodes_, values(k), of_nodes);
    const double mass = flow_.density * weights_[at];
    sum[0] += mass, sum[1] += mass * u[0], sum[2] += mass * u[1];
  });
  return sum;
}

FlowPower FlowElementsOfShape::power(const FlowMoment& m) const {
  const FlowConstants c = constants(m);
  FlowPower power;
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    const NodalFlow there = nodal_flow(e, m);
    for_points(e, m, [&](FlowPoint& at) {
      at.evaluate(c, there);
      const double shear = at.L[0][1] + at.L[1][0], growth = at.L[0][0] + at.L[1][1];
      power.dissipated += at.weight * c.mu * (2 * (at.L[0][0] * at.L[0][0] + at.L[1][1] * at.L[1][1]) + shear * shear);
      power.body += at.weight * c.rho * dot(at.b, at.v);
      power.convected += at.weight * c.rho * dot(at.convection, at.v);
      if (c.stabilised)
        power.stabilised +=
            at.weight * (at.tau * dot(at.convection, at.residual) + (at.tau_L * at.divergence - at.p) * growth);
      else
        power.expansion -= at.weight * at.p * growth;
    });
  }
  const auto velocity = [&](const SidePoint& on) { return mean(nodes_, on.at.N, nodal_flow(on.element, m).vt); };
  const auto carried = [&](const SidePoint& on) {
    const Vec<2> v = velocity(on);
    return 0.5 * c.rho * square_of(v) * dot(v, on.normal);
  };
  for (const SidePoint& on : open_) power.carried_by_open += carried(on);
  for (const SidePoint& on : inflow_) power.carried_by_inflows += carried(on);
  for (const SidePoint& on : open_) power.open_traction += dot(velocity(on), open_traction(c, m, on));
  return power;
}

/// <N_A, sigma n> over the element sides at the ends: half of it, of the side's own with the other sign. Where they
/// slip, what acts along them is known to be nothing.
std::vector<NodeForce> FlowElementsOfShape::corner_forces(const FlowMoment& m, std::size_t k) const {
  std::vector<NodeForce> forces;
  for (const Corner& corner : corners_[k]) {
    for (const SidePoint& on : corner.points) {
      const auto [xx, yy, xy] = stress_at(m, on.element, on.at.s);
      const Vec<2>& n = on.normal;
      Vec<2> traction{xx * n[0] + xy * n[1], xy * n[0] + yy * n[1]};
      const double pull = dot(n, traction) / square_of(n);
      if (corner.side.slip) traction = {n[0] * pull, n[1] * pull};
      for (const int a : corner.side.shared) {
        const int node = corner.side.nodes[static_cast<std::size_t>(a)];
        const int* nodes = mesh_.element(on.element);
        const double N = on.at.N[static_cast<std::size_t>(std::find(nodes, nodes + nodes_, node) - nodes)];
        const double part = corner.side.own ? -0.5 * N : 0.5 * N;
        forces.push_back({static_cast<std::size_t>(node), {part * traction[0], part * traction[1]}});
      }
    }
  }
  return forces;
}

/// sigma of (38): xx, yy, xy.
std::array<double, 3> FlowElementsOfShape::stress_at(const FlowMoment& m, std::size_t e, const Vec<2>& s) const {
  const PlaneMap map = plane_map(nodes_, fem::gathered(mesh_, e, mesh_.x), plane_point(mesh_.kind, s));
  const NodalFlow there = nodal_flow(e, m);
  const PlaneMatrix L = slopes(nodes_, there.vt, map.gradients);
  const double p = pressure_at(PressureShape::values(s), there.p);
  return {2 * m.viscosity * L[0][0] - p, 2 * m.viscosity * L[1][1] - p, m.viscosity * (L[0][1] + L[1][0])};
}

std::vector<double> FlowElementsOfShape::vorticity(std::span<const double> v) const {
  std::vector<double> sum(mesh_.node_count(), 0.0), volume(mesh_.node_count(), 0.0);
  for_all_points(v, [&](std::size_t e, std::size_t k, std::size_t at, const PlaneVectors& of_nodes) {
    const PlaneMatrix L = slopes(nodes_, of_nodes, gradients(at));
    for (std::size_t a = 0; a < nodes_; ++a) {
      const double part = weights_[at] * std::abs(values(k)[a]);
      sum[node(e, a)] += part * (L[1][0] - L[0][1]), volume[node(e, a)] += part;
    }
  });
  for (std::size_t n = 0; n < sum.size(); ++n) sum[n] /= std::max(volume[n], std::numeric_limits<double>::min());
  unknowns_.copy_to_twins(sum, 1);
  return sum;
}

SparseMatrix FlowElementsOfShape::laplacian(std::span<const int> unknown) const {
  std::vector<int> unknowns;
  for (const int node : mesh_.nodes) unknowns.push_back(unknown[static_cast<std::size_t>(node)]);
  const std::size_t count = static_cast<std::size_t>(*std::max_element(unknown.begin(), unknown.end())) + 1;
  const NodalPattern pattern(1, count, unknowns, static_cast<int>(nodes_));
  SparseMatrix A = pattern.matrix();
  std::vector<double> k(nodes_ * nodes_);
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    std::ranges::fill(k, 0.0);
    for (std::size_t q = 0; q < shape_.points.size(); ++q) {
      const std::size_t at = e * shape_.points.size() + q;
      const auto G = gradients(at);
      for (std::size_t a = 0; a < nodes_; ++a) {
        for (std::size_t b = 0; b < nodes_; ++b) k[a * nodes_ + b] += weights_[at] * dot(G[a], G[b]);
      }
    }
    pattern.add(e, k, A);
  }
  return A;
}

std::vector<double> FlowElementsOfShape::stream_source(std::span<const double> v) const {
  std::vector<double> source(mesh_.node_count(), 0.0);
  for_all_points(v, [&](std::size_t e, std::size_t k, std::size_t at, const PlaneVectors& of_nodes) {
    const Vec<2> u = mean(nodes_, values(k), of_nodes);
    const auto G = gradients(at);
    for (std::size_t a = 0; a < nodes_; ++a)
      source[static_cast<std::size_t>(mesh_.element(e)[a])] += weights_[at] * (G[a][1] * u[0] - G[a][0] * u[1]);
  });
  return source;
}

std::vector<double> FlowElementsOfShape::pressure_at_nodes(std::span<const double> p) const {
  std::vector<double> all(mesh_.node_count(), 0.0);
  const int line = side_node_count_of(mesh_.kind);
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    const Pressures at = pressures(e, p);
    for (int a = 0; a < static_cast<int>(nodes_); ++a) {
      const Vec<2> s{2.0 * (a % line) / (line - 1) - 1, 2.0 * (a / line) / (line - 1) - 1};
      all[static_cast<std::size_t>(mesh_.element(e)[a])] = pressure_at(PressureShape::values(s), at);
    }
  }
  return all;
}

template <class Vectors>
SparseMatrix FlowElementsOfShape::pressure_matrix(const Vectors& vectors) const {
  std::vector<int> first{0};  // pressures that are unknown, in the order of their nodes and so of the unknowns
  for (std::size_t n = 0; n < mesh_.node_count(); ++n)
    first.push_back(first.back() + (static_cast<std::size_t>(flow_.twin[n]) == n && unknowns_.pressure[n] >= 0));
  const ClusterPattern pattern(first, clusters_of(flow_));
  SparseMatrix A = pattern.matrix();
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    std::array<double, pressures_of_element * pressures_of_element> k{};
    for (std::size_t point = 0; point < shape_.points.size(); ++point) {
      const PressureVectors of = vectors(e, point);
      for (std::size_t q = 0; q < pressures_of_element; ++q) {
        for (std::size_t s = 0; s < pressures_of_element; ++s)
          k[q * pressures_of_element + s] += weights_[e * shape_.points.size() + point] * dot(of[q], of[s]);
      }
    }
    std::array<int, pressures_of_element> number;
    for (std::size_t q = 0; q < pressures_of_element; ++q) {
      const std::size_t n = pressure_node(e, q);
      number[q] = unknowns_.pressure[n] < 0 ? -1 : first[n];
    }
    pattern.add(e, corner_, number, k, A);
  }
  return A;
}

SparseMatrix FlowElementsOfShape::pressure_mass() const {
  return pressure_matrix([&](std::size_t, std::size_t k) {
    PressureVectors of{};
    for (std::size_t q = 0; q < pressures_of_element; ++q) of[q][0] = pressure_values_[k][q];
    return of;
  });
}

SparseMatrix FlowElementsOfShape::pressure_laplacian() const {
  SparseMatrix A = pressure_matrix([&](std::size_t e, std::size_t k) {
    const PlanePoint& at = shape_.points[k];
    const auto S = PressureShape::gradients(at.s);
    const auto [s, t] = plane_map(nodes_, fem::gathered(mesh_, e, mesh_.x), at).to_reference;
    PressureVectors G;
    for (std::size_t q = 0; q < pressures_of_element; ++q) {
      for (std::size_t i = 0; i < 2; ++i) G[q][i] = s[i] * S[2 * q] + t[i] * S[2 * q + 1];
    }
    return G;
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

double FlowElementsOfShape::mean_lsic(const FlowMoment& m) const {
  const FlowConstants c = constants(m);
  if (!c.stabilised) return 0;
  double sum = 0, volume = 0;
  for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
    const NodalFlow there = nodal_flow(e, m);
    for_points(e, m, [&](FlowPoint& at) {
      at.evaluate(c, there);
      sum += at.weight * at.tau_L, volume += at.weight;
    });
  }
  return sum / volume;
}

}  // namespace tether::fem
