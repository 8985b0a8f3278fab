// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <utility>

#include "grid/brick.hpp"
#include "grid/elements.hpp"

namespace tether {

/// A set of places that symmetry makes of one, in areas or volumes of the parts that a place cuts a simplex into: all
/// that have `a` `many` times, the rest of 1 in equal parts.
struct Orbit {
  int many = 0;
  double a = 0, weight = 0;  ///< weight of each place, those of a rule have the sum 1
};

/// Triangles and tetrahedra of order p over the corner of the unit cube. The rule for gradients has d + 1 points and is
/// exact to order 2; that for masses is exact to order 2 p.
template <int d, int p>
struct Simplex {
  static constexpr int dim = d, order = p, corners = d + 1;
  static constexpr int nodes = p == 1 ? corners : corners + d * (d + 1) / 2;
  static constexpr int points = corners, mass_points = p == 1 ? points : d == 2 ? 6 : 14;
  static constexpr bool is_simplex = true;
  static constexpr double volume = d == 2 ? 0.5 : 1.0 / 6;

  static Vec<d> corner(int k) {
    Vec<d> s{};
    if (k > 0) s[at(k - 1)] = 1;
    return s;
  }
  static Vec<d> node_place(int a) {
    if (a < corners) return corner(a);
    Vec<d> s{};
    for (const int end : ends_of_middle[at(a - corners)]) {
      if (end > 0) s[at(end - 1)] = 0.5;
    }
    return s;
  }
  static Values<corners> barycentric(const Vec<d>& s) {
    Values<corners> L{1};
    for (int k = 0; k < d; ++k) L[0] -= s[at(k)], L[at(k + 1)] = s[at(k)];
    return L;
  }
  static Values<nodes> values(const Vec<d>& s) {
    const Values<corners> L = barycentric(s);
    if constexpr (p == 1) {
      return L;
    } else {
      Values<nodes> N;
      for (int a = 0; a < corners; ++a) N[at(a)] = L[at(a)] * (2 * L[at(a)] - 1);
      for (int m = 0; m < nodes - corners; ++m) {
        const auto [a, b] = ends_of_middle[at(m)];
        N[at(corners + m)] = 4 * L[at(a)] * L[at(b)];
      }
      return N;
    }
  }
  static Values<nodes * d> gradients(const Vec<d>& s) {
    const Values<corners> L = barycentric(s);
    const auto slope = [](int a, int i) { return a == 0 ? -1.0 : a == i + 1 ? 1.0 : 0.0; };  // of L_a along i
    Values<nodes * d> G{};
    for (int i = 0; i < d; ++i) {
      for (int a = 0; a < corners; ++a) G[at(a * d + i)] = (p == 1 ? 1 : 4 * L[at(a)] - 1) * slope(a, i);
      for (int m = 0; m < nodes - corners; ++m) {
        const auto [a, b] = ends_of_middle[at(m)];
        G[at((corners + m) * d + i)] = 4 * (L[at(a)] * slope(b, i) + L[at(b)] * slope(a, i));
      }
    }
    return G;
  }
  /// Source: the symmetric rules of order 2 (A. H. Stroud, Approximate Calculation of Multiple Integrals, 1971).
  static Vec<d> place(int point) {
    const double near = d == 2 ? 2.0 / 3 : (5 + 3 * std::sqrt(5.0)) / 20, far = (1 - near) / d;
    Vec<d> s;
    for (int k = 0; k < d; ++k) s[at(k)] = point == k + 1 ? near : far;
    return s;
  }
  static double weight(int) { return volume / points; }
  static Vec<d> mass_place(int point) {
    if constexpr (p == 1) {
      return place(point);
    } else {
      return place_of_rule(point).second;
    }
  }
  static double mass_weight(int point) {
    if constexpr (p == 1) {
      return weight(point);
    } else {
      return volume * place_of_rule(point).first;
    }
  }
  static Vec<d> middle() {
    Vec<d> s;
    s.fill(1.0 / corners);
    return s;
  }
  /// Places where derivatives of these functions are most exact: the middle, or of order 2 the points of quadrature.
  static constexpr int samples = p == 1 ? 1 : points;
  static Vec<d> sample_place(int sample) { return p == 1 ? middle() : place(sample); }
  /// Returns what each point of quadrature adds to a field at s: derivatives of linear functions have one value, those
  /// of order 2 the linear function through the points.
  static Values<points> to_place(const Vec<d>& s, bool) {
    Values<points> parts;
    parts.fill(1.0 / points);
    if constexpr (p == 2) {
      const double near = place(1)[0], far = place(0)[0];
      const Values<corners> L = barycentric(s);
      for (int k = 0; k < points; ++k) parts[at(k)] = (L[at(k)] - far) / (near - far);
    }
    return parts;
  }

 private:
  /// Source: rules of order 4 of triangles (6 points; G. Strang and G. J. Fix, An Analysis of the Finite Element
  /// Method, 1973) and of order 5 of tetrahedra (14 points; N. J. Walkington, CMU report 00-CNA-023, 2000). All weights
  /// are positive, so that masses are.
  static auto orbits() {
    if constexpr (d == 2) {
      const double ten = std::sqrt(10.0), root = std::sqrt(38 - 44 * std::sqrt(0.4));
      const double split = std::sqrt(213125 - 53320 * ten);
      return std::array{Orbit{2, (8 - ten + root) / 18, (620 + split) / 3720},
                        Orbit{2, (8 - ten - root) / 18, (620 - split) / 3720}};
    } else {
      return std::array{Orbit{3, 0.31088591926330060980, 0.11268792571801585080},
                        Orbit{3, 0.092735250310891226402, 0.073493043116361949544},
                        Orbit{2, 0.045503704125649649492, 0.042546020777081466438}};
    }
  }
  /// Weight and place of one point of that rule.
  static std::pair<double, Vec<d>> place_of_rule(int point) {
    for (const Orbit& orbit : orbits()) {
      const bool of_edges = d == 3 && orbit.many == 2;
      const int count = of_edges ? 6 : corners;
      if (point >= count) {
        point -= count;
        continue;
      }
      const double rest = (1 - orbit.many * orbit.a) / (corners - orbit.many);
      Values<corners> L;
      L.fill(orbit.a);
      if (of_edges) {
        for (const int end : ends_of_middle[at(point)]) L[at(end)] = rest;
      } else {
        L[at(point)] = rest;
      }
      Vec<d> s;
      for (int k = 0; k < d; ++k) s[at(k)] = L[at(k + 1)];
      return {orbit.weight, s};
    }
    return {};
  }
};

}  // namespace tether
