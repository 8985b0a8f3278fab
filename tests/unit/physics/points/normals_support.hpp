// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "physics/points/normals.hpp"

namespace tether::mpm::curves {

constexpr double degree = std::numbers::pi / 180;

/// Points in order along a curve, with their exact unit tangents; other points may follow them.
struct Curve {
  std::vector<double> x, y, tx, ty;
  std::size_t size() const { return tx.size(); }

  void add(double at_x, double at_y, double along_x, double along_y) {
    const double length = std::hypot(along_x, along_y);
    x.push_back(at_x), y.push_back(at_y);
    tx.push_back(along_x / length), ty.push_back(along_y / length);
  }
  PlaceArrays places() const { return {x, y}; }
  Range range() const { return {0, size()}; }
};

/// An arc from one angle to another [degrees], its points in the middles of equal pieces.
inline Curve arc_curve(double centre_x, double centre_y, double radius, double from, double to, int count) {
  Curve curve;
  for (int k = 0; k < count; ++k) {
    const double angle = (from + (to - from) * (k + 0.5) / count) * degree;
    const double c = std::cos(angle), s = std::sin(angle);
    curve.add(centre_x + radius * c, centre_y + radius * s, -s, c);
  }
  return curve;
}

/// Points at distances along a straight line through a place, at an angle to x [degrees].
inline Curve line_curve(double through_x, double through_y, double angle, const std::vector<double>& distances) {
  Curve curve;
  const double c = std::cos(angle * degree), s = std::sin(angle * degree);
  for (const double d : distances) curve.add(through_x + d * c, through_y + d * s, c, s);
  return curve;
}

/// Tangents by connectivity, with which a run begins: chords of the neighbours (7.1).
inline std::pair<std::vector<double>, std::vector<double>> chords(const Curve& curve) {
  std::vector<double> tx, ty;
  for (std::size_t p = 0; p < curve.size(); ++p) {
    const std::size_t before = p > 0 ? p - 1 : p, behind = p + 1 < curve.size() ? p + 1 : p;
    const double dx = curve.x[behind] - curve.x[before], dy = curve.y[behind] - curve.y[before];
    const double length = std::hypot(dx, dy);
    tx.push_back(length > 0 ? dx / length : 1), ty.push_back(length > 0 ? dy / length : 0);
  }
  return {tx, ty};
}

/// Angles between tangents and the exact ones, 0 to 180 [degrees].
inline std::vector<double> angles(const Curve& curve, const std::vector<double>& tx, const std::vector<double>& ty) {
  std::vector<double> of;
  for (std::size_t p = 0; p < curve.size(); ++p) {
    const double sine = tx[p] * curve.ty[p] - ty[p] * curve.tx[p], cosine = tx[p] * curve.tx[p] + ty[p] * curve.ty[p];
    of.push_back(std::atan2(std::abs(sine), cosine) / degree);
  }
  return of;
}

inline double rms(const std::vector<double>& of) {
  double sum = 0;
  for (const double a : of) sum += a * a;
  return std::sqrt(sum / static_cast<double>(of.size()));
}
inline double largest(const std::vector<double>& of) { return *std::max_element(of.begin(), of.end()); }

/// How a rule is asked: on which grid, between which walls, beside which points.
struct Setting {
  BackgroundGrid grid{6, 6, -2, 3, -2, 3};  // unit cells; the middle one is [0, 1] x [0, 1]
  Walls walls{Wall::open, Wall::open, Wall::open, Wall::open};
  Method method;
};

inline Setting setting(NormalRule rule, MatrixScope scope = MatrixScope::cell, LonePoint alone = LonePoint::ghost) {
  Setting s;
  s.method.normals = rule, s.method.matrix = scope, s.method.lone_point = alone;
  return s;
}

/// Tangents of the curve by a rule that begins with `tx`, `ty`; points behind the curve's lend their colour.
inline void turn(const Curve& curve, const Setting& s, std::vector<double>& tx, std::vector<double>& ty) {
  const std::vector<Slots> others{{curve.size(), curve.x.size(), false}};
  MembraneNormals(s.grid, s.walls, s.method, curve.size()).update(curve.places(), curve.range(), others, {tx, ty});
}

/// Errors of a rule that begins with the chords [degrees].
inline std::vector<double> errors(const Curve& curve, const Setting& s) {
  auto [tx, ty] = chords(curve);
  turn(curve, s, tx, ty);
  return angles(curve, tx, ty);
}

}  // namespace tether::mpm::curves
