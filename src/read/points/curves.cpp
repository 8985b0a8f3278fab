// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/points/curves.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/sin_pi.hpp>
#include <cassert>
#include <cmath>
#include <numbers>

namespace tether {
namespace {

using std::numbers::pi;

/// Relative errors at which quadrature and inversion stop, far below what they are asked for (1e-12).
constexpr double quadrature_accuracy = 1e-14, inversion_accuracy = 1e-13;

Vec<2> lerp(const Vec<2>& a, const Vec<2>& b, double t) { return {std::lerp(a[0], b[0], t), std::lerp(a[1], b[1], t)}; }

// Places: t runs from 0 to 1 along a stretch, and both ends are met exactly.

Vec<2> place(const Straight& line, double t) { return lerp(line.a, line.b, t); }

Vec<2> place(const EllipseArc& arc, double t) {
  const double u = std::lerp(arc.from, arc.to, t);
  return {arc.centre[0] + arc.a * boost::math::cos_pi(u), arc.centre[1] + arc.b * boost::math::sin_pi(u)};
}

Vec<2> place(const Cubic& cubic, double t) {  // de Casteljau
  const auto& c = cubic.control;
  const Vec<2> a = lerp(c[0], c[1], t), b = lerp(c[1], c[2], t), d = lerp(c[2], c[3], t);
  return lerp(lerp(a, b, t), lerp(b, d, t), t);
}

// Speeds: what of the length a unit of t runs through.

double speed(const Straight& line, double) { return distance(line.a, line.b); }

double speed(const EllipseArc& arc, double t) {
  const double u = std::lerp(arc.from, arc.to, t);
  return pi * std::abs(arc.to - arc.from) * std::hypot(arc.a * boost::math::sin_pi(u), arc.b * boost::math::cos_pi(u));
}

double speed(const Cubic& cubic, double t) {
  const auto& c = cubic.control;
  const auto step = [&](std::size_t k) { return Vec<2>{c[k + 1][0] - c[k][0], c[k + 1][1] - c[k][1]}; };
  const Vec<2> slope = lerp(lerp(step(0), step(1), t), lerp(step(1), step(2), t), t);
  return 3 * std::hypot(slope[0], slope[1]);
}

// Lengths from 0 to t.

double length_to(const Straight& line, double t) { return t * distance(line.a, line.b); }

/// E(phi, k), the elliptic integral of the second kind, for phi = pi w from 0 to pi/2 and k^2 = 1 - complement.
/// Carlson's form (DLMF 19.25.10) of which no term is negative; and with the complement given it is exact for the
/// flattest ellipse, of which k itself rounds to 1.
double elliptic_quarter(double w, double complement) {
  const double s = boost::math::sin_pi(w), c = boost::math::cos_pi(w);
  if (s == 0) return 0;
  const double cc = c * c, k2 = 1 - complement, delta2 = cc + complement * s * s;
  const double integrals =
      boost::math::ellint_rf(cc, delta2, 1.0) + k2 / 3 * s * s * boost::math::ellint_rd(cc, 1.0, delta2);
  return s * (complement * integrals + k2 * c / std::sqrt(delta2));
}

/// Returns the same for any phi = pi w: quarters before it, each from 0 to pi/2 or back.
double elliptic_integral(double w, double complement) {
  const double quarters = std::floor(2 * w), rest = w - 0.5 * quarters, quarter = elliptic_quarter(0.5, complement);
  const bool back = std::fmod(quarters, 2) != 0;
  return back ? (quarters + 1) * quarter - elliptic_quarter(0.5 - rest, complement)
              : quarters * quarter + elliptic_quarter(rest, complement);
}

/// Arc length of x = a cos(pi u), y = b sin(pi u), counted from an end of the short half axis, where phi is 0.
double length_from_short_axis(double a, double b, double u) {
  const double most = std::max(a, b), ratio = std::min(a, b) / most;
  const double complement = std::max(ratio * ratio, 1e-290);  // above 0, where the forms would be 0/0
  return most * elliptic_integral(a < b ? u : u + 0.5, complement);
}

double length_to(const EllipseArc& arc, double t) {
  return std::abs(length_from_short_axis(arc.a, arc.b, std::lerp(arc.from, arc.to, t)) -
                  length_from_short_axis(arc.a, arc.b, arc.from));
}

/// Integral of a speed from a to b, halved until halves and whole agree. A sharp spline nearly stands still somewhere,
/// where the speed has a kink: only its halves are then halved on.
template <class Speed>
double adaptive_integral(const Speed& of, double a, double b, double whole, double error, int halvings) {
  using Rule = boost::math::quadrature::gauss<double, 15>;
  const double middle = 0.5 * (a + b);
  const double left = Rule::integrate(of, a, middle), right = Rule::integrate(of, middle, b);
  if (halvings == 0 || !(std::abs(left + right - whole) > error)) return left + right;
  return adaptive_integral(of, a, middle, left, error, halvings - 1) +
         adaptive_integral(of, middle, b, right, error, halvings - 1);
}

double length_to(const Cubic& cubic, double t) {
  const auto of = [&cubic](double s) { return speed(cubic, s); };
  const double rough = boost::math::quadrature::gauss<double, 15>::integrate(of, 0.0, t);
  return t > 0 ? adaptive_integral(of, 0, t, rough, quadrature_accuracy * rough, 40) : 0;
}

/// The t up to which a stretch is s long: Newton's method, kept within a bracket that every step narrows, since the
/// speed of a flat ellipse or of a sharp spline nearly vanishes.
template <class AnyStretch>
double parameter_at(const AnyStretch& stretch, double s, double length) {
  double low = 0, high = 1, t = s / length;
  for (int k = 0; k < 100 && low < high; ++k) {
    const double excess = length_to(stretch, t) - s;
    if (std::abs(excess) <= inversion_accuracy * length) break;
    (excess > 0 ? high : low) = t;
    const double next = t - excess / speed(stretch, t);
    t = next > low && next < high ? next : 0.5 * (low + high);
  }
  return t;
}

Vec<2> place(const Stretch& stretch, double t) {
  return std::visit([t](const auto& any) { return place(any, t); }, stretch);
}

Stretch cubic(const Vec<2>& a, const Vec<2>& slope_a, const Vec<2>& b, const Vec<2>& slope_b, double h) {
  return Cubic{{a,
                {a[0] + slope_a[0] * h / 3, a[1] + slope_a[1] * h / 3},
                {b[0] - slope_b[0] * h / 3, b[1] - slope_b[1] * h / 3},
                b}};
}

/// The equations of a spline's slopes at its knots: row k of a matrix, and its right-hand side. All rows are diagonally
/// dominant, so that elimination needs no pivots; a spline has 100 knots at most.
struct Slopes {
  std::vector<std::vector<double>> matrix;
  std::vector<Vec<2>> right;

  explicit Slopes(std::size_t knots) : matrix(knots, std::vector<double>(knots, 0.0)), right(knots) {}

  /// Adds for the chord of length h from a at knot i to b at knot j its share of the condition that the second
  /// derivative on its side of either knot be the one on the other side, or zero where there is none.
  void add_chord(std::size_t i, const Vec<2>& a, std::size_t j, const Vec<2>& b, double h) {
    const Vec<2> pull{3 * (b[0] - a[0]) / (h * h), 3 * (b[1] - a[1]) / (h * h)};
    for (const auto& [knot, other] : {std::pair{i, j}, std::pair{j, i}}) {
      matrix[knot][knot] += 2 / h, matrix[knot][other] += 1 / h;
      right[knot][0] += pull[0], right[knot][1] += pull[1];
    }
  }
  std::vector<Vec<2>> solution() &&;
};

std::vector<Vec<2>> Slopes::solution() && {
  const std::size_t n = right.size();
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t row = k + 1; row < n; ++row) {
      const double factor = matrix[row][k] / matrix[k][k];
      for (std::size_t c = k; c < n; ++c) matrix[row][c] -= factor * matrix[k][c];
      right[row][0] -= factor * right[k][0], right[row][1] -= factor * right[k][1];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t c = k + 1; c < n; ++c) {
      right[k][0] -= matrix[k][c] * right[c][0], right[k][1] -= matrix[k][c] * right[c][1];
    }
    right[k][0] /= matrix[k][k], right[k][1] /= matrix[k][k];
  }
  return std::move(right);
}

/// Number of whole pieces that n points have; half pieces count half.
double pieces_of(double n, EndPoints ends) { return n - 0.5 * (ends.first ? 1 : 0) - 0.5 * (ends.last ? 1 : 0); }

}  // namespace

double distance(const Vec<2>& a, const Vec<2>& b) { return std::hypot(b[0] - a[0], b[1] - a[1]); }

Curve::Curve(std::vector<Stretch> stretches) : stretches_(std::move(stretches)) {
  assert(!stretches_.empty());
  begins_.push_back(0);
  for (const Stretch& stretch : stretches_) {
    begins_.push_back(begins_.back() + std::visit([](const auto& any) { return length_to(any, 1); }, stretch));
  }
}

Vec<2> Curve::first() const { return place(stretches_.front(), 0); }
Vec<2> Curve::last() const { return place(stretches_.back(), 1); }

Vec<2> Curve::at(double s) const {
  if (!(s > 0)) return first();
  if (s >= length()) return last();
  // The last stretch that begins at or before s: never one without a length.
  const auto behind = std::upper_bound(begins_.begin(), begins_.end(), s);
  const auto k = static_cast<std::size_t>(behind - begins_.begin()) - 1;
  const double whole = begins_[k + 1] - begins_[k];
  return std::visit([&](const auto& any) { return place(any, parameter_at(any, s - begins_[k], whole)); },
                    stretches_[k]);
}

Curve polyline(const std::vector<Vec<2>>& vertices) {
  std::vector<Stretch> lines;
  for (std::size_t k = 1; k < vertices.size(); ++k) lines.emplace_back(Straight{vertices[k - 1], vertices[k]});
  return Curve(std::move(lines));
}

Curve ellipse_arc(const Vec<2>& centre, double a, double b, double from, double to) {
  return Curve({EllipseArc{centre, a, b, from / 180, to / 180}});
}

Curve spline(const std::vector<Vec<2>>& vertices) {
  std::vector<double> chords;
  double total = 0;
  for (std::size_t k = 1; k < vertices.size(); ++k) {
    chords.push_back(distance(vertices[k - 1], vertices[k]));
    total += chords.back();
  }
  const bool closed = distance(vertices.front(), vertices.back()) <= same_place * total;
  const std::size_t knots = closed ? chords.size() : vertices.size();
  Slopes slopes(knots);
  for (std::size_t k = 0; k < chords.size(); ++k) {
    slopes.add_chord(k, vertices[k], (k + 1) % knots, vertices[k + 1], chords[k]);
  }
  const std::vector<Vec<2>> slope = std::move(slopes).solution();
  std::vector<Stretch> cubics;
  for (std::size_t k = 0; k < chords.size(); ++k) {
    cubics.push_back(cubic(vertices[k], slope[k], vertices[k + 1], slope[(k + 1) % knots], chords[k]));
  }
  return Curve(std::move(cubics));
}

Curve joined(const std::vector<Curve>& curves) {
  std::vector<Stretch> all;
  for (const Curve& curve : curves) all.insert(all.end(), curve.stretches().begin(), curve.stretches().end());
  return Curve(std::move(all));
}

bool is_closed(const Curve& curve) { return distance(curve.first(), curve.last()) <= same_place * curve.length(); }

Seeds seeds(const Curve& curve, std::size_t n, EndPoints ends) {
  const double piece = curve.length() / pieces_of(static_cast<double>(n), ends);
  Seeds found;
  for (std::size_t k = 0; k < n; ++k) {
    const bool at_first = ends.first && k == 0, at_last = ends.last && k + 1 == n;
    const double s = (static_cast<double>(k) + (ends.first ? 0.0 : 0.5)) * piece;
    found.places.push_back(at_last ? curve.last() : curve.at(s));
    found.pieces.push_back(at_first || at_last ? 0.5 * piece : piece);
  }
  return found;
}

double seed_count(const Curve& curve, double spacing, EndPoints ends) {
  const double half_pieces = pieces_of(0, ends);  // 0, -1/2 or -1
  return std::round(curve.length() / spacing - half_pieces);
}

}  // namespace tether
