// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "algebra/saddle_solver.hpp"
#include "algebra/sparse_matrix.hpp"

// One Newton step of an incompressible flow on the unit square, rho = 1, of speeds up to 1: the matrices that solvers
// of large systems are tried on. Mid-point rule: velocities at the step's end count half.

namespace tether {

enum class ElementPair { q1q1, q2q1 };

struct FlowCase {
  ElementPair element = ElementPair::q2q1;
  int cells = 8;          ///< along a side
  double reynolds = 100;  ///< of the square's side
  double dt = 0.1;
  double stiff = 0;   ///< viscosity that a solid in the middle adds
  bool open = false;  ///< a channel open on the right instead of a vortex between walls whose lid moves
};

struct FlowProblem {
  SparseMatrix K, Mp, Lp;
  std::vector<double> b;
  SaddleUnknowns unknowns;
  double viscous = 0, inertial = 0;
};

/// Lagrange functions and slopes of order p along a line at s.
struct LineShapes {
  std::array<double, 3> N{}, dN{};
  LineShapes(int p, double s) {
    if (p == 1) N = {0.5 * (1 - s), 0.5 * (1 + s), 0}, dN = {-0.5, 0.5, 0};
    if (p == 2) N = {0.5 * s * (s - 1), 1 - s * s, 0.5 * s * (s + 1)}, dN = {s - 0.5, -2 * s, s + 0.5};
  }
};

/// Values and gradients of an element's functions of order p at (s, t), cells of width h.
struct CellShapes {
  int count;
  std::array<double, 9> N{};
  std::array<std::array<double, 2>, 9> G{};
  CellShapes(int p, double s, double t, double h) : count((p + 1) * (p + 1)) {
    const LineShapes x(p, s), y(p, t);
    for (std::size_t a = 0; a < static_cast<std::size_t>(count); ++a) {
      const std::size_t i = a % static_cast<std::size_t>(p + 1), j = a / static_cast<std::size_t>(p + 1);
      N[a] = x.N[i] * y.N[j], G[a] = {x.dN[i] * y.N[j] * 2 / h, x.N[i] * y.dN[j] * 2 / h};
    }
  }
};

/// Speed and its gradient dv_i / dx_j about which a step is linearised.
struct GivenFlow {
  std::array<double, 2> v{};
  std::array<std::array<double, 2>, 2> gradient{};
  bool solid;
  GivenFlow(bool open, double x, double y) : solid(std::abs(x - 0.5) < 0.05 && std::abs(y - 0.5) < 0.25) {
    if (open) {
      v = {4 * y * (1 - y), 0}, gradient[0] = {0, 4 - 8 * y};
      return;
    }
    constexpr double pi = std::numbers::pi;
    const double sx = std::sin(pi * x), sy = std::sin(pi * y), s2x = std::sin(2 * pi * x), s2y = std::sin(2 * pi * y);
    v = {sx * sx * s2y, -s2x * sy * sy};
    gradient[0] = {pi * s2x * s2y, 2 * pi * sx * sx * std::cos(2 * pi * y)};
    gradient[1] = {-2 * pi * std::cos(2 * pi * x) * sy * sy, -pi * s2x * s2y};
  }
};

/// A matrix with the pattern of elements that have `per_element` unknowns each.
inline SparseMatrix pattern_of(std::int64_t n, const std::vector<std::int64_t>& unknowns, std::size_t per_element) {
  std::vector<std::vector<std::int32_t>> elements(static_cast<std::size_t>(n));
  for (std::size_t k = 0; k < unknowns.size(); ++k)
    elements[static_cast<std::size_t>(unknowns[k])].push_back(static_cast<std::int32_t>(k / per_element));
  SparseMatrix A;
  A.n = n, A.start.push_back(0);
  std::vector<std::int64_t> rows;
  for (const auto& list : elements) {
    rows.clear();
    for (const std::int32_t e : list) {
      const auto first = unknowns.begin() + static_cast<std::ptrdiff_t>(e) * static_cast<std::ptrdiff_t>(per_element);
      rows.insert(rows.end(), first, first + static_cast<std::ptrdiff_t>(per_element));
    }
    std::sort(rows.begin(), rows.end());
    A.row.insert(A.row.end(), rows.begin(), std::unique(rows.begin(), rows.end()));
    A.start.push_back(static_cast<std::int64_t>(A.row.size()));
  }
  A.row.shrink_to_fit();
  A.value.resize(A.row.size());
  return A;
}

inline void add_at(SparseMatrix& A, std::int64_t i, std::int64_t j, double value) {
  const auto first = A.row.begin() + A.start[static_cast<std::size_t>(j)];
  const auto end = A.row.begin() + A.start[static_cast<std::size_t>(j) + 1];
  A.value[static_cast<std::size_t>(std::lower_bound(first, end, i) - A.row.begin())] += value;
}

/// Makes a FlowProblem of a FlowCase.
class FlowAssembly {
 public:
  explicit FlowAssembly(const FlowCase& flow) : flow_(flow), p_(flow.element == ElementPair::q2q1 ? 2 : 1) {
    number_unknowns();
    collect_unknowns();
  }

  FlowProblem problem() {
    FlowProblem result;
    result.unknowns = {is_pressure_, {first_.begin(), first_.end()}, !flow_.open};
    result.unknowns.first.push_back(static_cast<int>(unknown_count_));
    result.K = pattern_of(unknown_count_, unknowns_, per_element());
    result.Mp = pattern_of(pressure_count_, pressures_, 4), result.Lp = result.Mp;
    for (int e = 0; e < flow_.cells * flow_.cells; ++e) add_element(e, result);
    hold_walls(result);
    result.viscous = 1 / flow_.reynolds + tau_div_sum_ / (4.0 * flow_.cells * flow_.cells);  // 2 theta mu + ...
    result.inertial = 1 / flow_.dt;
    return result;
  }

 private:
  std::size_t per_element() const { return static_cast<std::size_t>(2 * (p_ + 1) * (p_ + 1) + 4); }
  int line() const { return p_ * flow_.cells + 1; }
  std::int64_t node(int i, int j) const { return std::int64_t{j} * line() + i; }

  void number_unknowns() {
    for (int j = 0; j < line(); ++j) {
      for (int i = 0; i < line(); ++i) {
        first_.push_back(unknown_count_);
        const bool corner = i % p_ == 0 && j % p_ == 0;
        pressure_.push_back(corner ? pressure_count_++ : -1);
        is_pressure_.insert(is_pressure_.end(), {0, 0});
        if (corner) is_pressure_.push_back(1);
        unknown_count_ += corner ? 3 : 2;
      }
    }
  }
  void collect_unknowns() {
    for (int e = 0; e < flow_.cells * flow_.cells; ++e) {
      const int i0 = p_ * (e % flow_.cells), j0 = p_ * (e / flow_.cells);
      for (int a = 0; a < (p_ + 1) * (p_ + 1); ++a) {
        const auto at = first_[static_cast<std::size_t>(node(i0 + a % (p_ + 1), j0 + a / (p_ + 1)))];
        unknowns_.push_back(at), unknowns_.push_back(at + 1);
      }
      for (int a = 0; a < 4; ++a) {
        const auto corner = static_cast<std::size_t>(node(i0 + p_ * (a % 2), j0 + p_ * (a / 2)));
        unknowns_.push_back(first_[corner] + 2), pressures_.push_back(pressure_[corner]);
      }
    }
  }

  void add_element(int e, FlowProblem& to) {
    k_.assign(per_element() * per_element(), 0.0);
    std::array<double, 16> mass{}, laplacian{};
    const double h = 1.0 / flow_.cells, far = std::sqrt(0.6);
    for (int q = 0; q < 9; ++q) {
      const double s = far * (q % 3 - 1), t = far * (q / 3 - 1);
      const double weight = (q % 3 == 1 ? 8.0 : 5.0) * (q / 3 == 1 ? 8.0 : 5.0) / 81 * h * h / 4;
      const GivenFlow given(flow_.open, h * (e % flow_.cells + 0.5 + 0.5 * s), h * (e / flow_.cells + 0.5 + 0.5 * t));
      add_point(given, CellShapes(p_, s, t, h), CellShapes(1, s, t, h), weight);
      const CellShapes P(1, s, t, h);
      for (std::size_t a = 0; a < 16; ++a) {
        const std::size_t i = a / 4, j = a % 4;
        mass[a] += weight * P.N[i] * P.N[j] / (1 + (given.solid ? flow_.stiff * flow_.reynolds : 0));
        laplacian[a] += weight * (P.G[i][0] * P.G[j][0] + P.G[i][1] * P.G[j][1]);
      }
    }
    const std::size_t size = per_element(), first = static_cast<std::size_t>(e) * size;
    for (std::size_t a = 0; a < size * size; ++a)
      add_at(to.K, unknowns_[first + a / size], unknowns_[first + a % size], k_[a]);
    for (std::size_t a = 0; a < 16; ++a) {
      const auto i = pressures_[4 * static_cast<std::size_t>(e) + a / 4];
      const auto j = pressures_[4 * static_cast<std::size_t>(e) + a % 4];
      add_at(to.Mp, i, j, mass[a]), add_at(to.Lp, i, j, laplacian[a]);
    }
  }

  void add_point(const GivenFlow& given, const CellShapes& V, const CellShapes& P, double weight) {
    const double h = 1.0 / flow_.cells, nu = 1 / flow_.reynolds, G = 4 / (h * h), theta = 0.5;
    const auto& [v, dv, solid] = given;
    const double viscosity = nu + (solid ? flow_.stiff : 0);
    double tau = 0, tau_div = 0;
    if (flow_.element == ElementPair::q1q1) {
      tau = 1 / std::sqrt(4 / (flow_.dt * flow_.dt) + G * (v[0] * v[0] + v[1] * v[1]) + 9 * nu * nu * G * G);
      tau_div = 1 / (tau * 2 * G);
      tau_div_sum_ += weight * 4 * flow_.cells * flow_.cells * tau_div;
    }
    const auto count = static_cast<std::size_t>(V.count), pressures = 2 * count;
    const auto at = [&](std::size_t i, std::size_t j) -> double& { return k_[i * per_element() + j]; };
    for (std::size_t b = 0; b < count; ++b) {
      const double along = v[0] * V.G[b][0] + v[1] * V.G[b][1], rate = V.N[b] / flow_.dt + theta * along;
      for (std::size_t j = 0; j < 2; ++j) {
        std::array<double, 2> R{theta * V.N[b] * dv[0][j], theta * V.N[b] * dv[1][j]};  // rho (dv/dt + convection)
        R[j] += rate;
        for (std::size_t a = 0; a < count; ++a) {
          const double test = V.N[a] + tau * (v[0] * V.G[a][0] + v[1] * V.G[a][1]);
          const double both = V.G[a][0] * V.G[b][0] + V.G[a][1] * V.G[b][1];
          for (std::size_t i = 0; i < 2; ++i) {
            at(2 * a + i, 2 * b + j) +=
                weight * (test * R[i] + theta * viscosity * ((i == j ? both : 0) + V.G[a][j] * V.G[b][i]) +
                          tau_div * V.G[a][i] * V.G[b][j]);
          }
        }
        for (std::size_t a = 0; a < 4; ++a) {
          at(pressures + a, 2 * b + j) += weight * (P.N[a] * V.G[b][j] + tau * (P.G[a][0] * R[0] + P.G[a][1] * R[1]));
        }
      }
    }
    for (std::size_t b = 0; b < 4; ++b) {
      for (std::size_t a = 0; a < count; ++a) {
        const double upwind = tau * (v[0] * V.G[a][0] + v[1] * V.G[a][1]);
        for (std::size_t i = 0; i < 2; ++i)
          at(2 * a + i, pressures + b) += weight * (-V.G[a][i] * P.N[b] + upwind * P.G[b][i]);
      }
      for (std::size_t a = 0; a < 4; ++a)
        at(pressures + a, pressures + b) += weight * tau * (P.G[a][0] * P.G[b][0] + P.G[a][1] * P.G[b][1]);
    }
  }

  /// The lid's speed, or the inflow's, goes to the right side; what is held there is 0 in the solution.
  void hold_walls(FlowProblem& to) const {
    std::vector<std::uint8_t> held(static_cast<std::size_t>(unknown_count_), 0);
    std::vector<std::uint8_t> held_pressure(static_cast<std::size_t>(pressure_count_), 0);
    std::vector<double> given(held.size(), 0.0);
    for (int j = 0; j < line(); ++j) {
      for (int i = 0; i < line(); ++i) {
        const bool right = i == line() - 1, wall = i == 0 || j == 0 || j == line() - 1;
        const auto at = static_cast<std::size_t>(node(i, j));
        const auto unknown = static_cast<std::size_t>(first_[at]);
        if (wall || (right && !flow_.open)) held[unknown] = held[unknown + 1] = 1;
        if (right && flow_.open && pressure_[at] >= 0) held_pressure[static_cast<std::size_t>(pressure_[at])] = 1;
        const double y = static_cast<double>(j) / (line() - 1), lid = j == line() - 1 && i > 0 && !right ? 1 : 0;
        given[unknown] = flow_.open ? (i == 0 ? 4 * y * (1 - y) : 0) : lid;
      }
    }
    if (!flow_.open) held[2] = held_pressure[0] = 1;  // the first pressure
    to.b.resize(held.size());
    to.K.multiply(given, to.b);
    for (std::size_t i = 0; i < held.size(); ++i) to.b[i] = held[i] ? 0 : -to.b[i];
    hold(to.K, held, 1);
    hold(to.Lp, held_pressure, 1);
  }

  FlowCase flow_;
  int p_;
  std::int64_t unknown_count_ = 0, pressure_count_ = 0;
  std::vector<std::int64_t> first_, pressure_, unknowns_, pressures_;
  std::vector<std::uint8_t> is_pressure_;
  std::vector<double> k_;
  double tau_div_sum_ = 0;
};

}  // namespace tether
