// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "base/vec.hpp"
#include "laws/tensors.hpp"

namespace tether {

/// A straight stretch from a to b.
struct Straight {
  Vec<2> a, b;  // [length]
};

/// (xc + a cos(pi u), yc + b sin(pi u)), u running from `from` to `to`: in half turns, so that a quarter of a turn ends
/// exactly on an axis.
struct EllipseArc {
  Vec<2> centre;        // [length]
  double a = 0, b = 0;  // half axes [length]
  double from = 0, to = 2;
};

/// A cubic stretch in Bezier's form: it begins and ends exactly at its first and last control point.
struct Cubic {
  std::array<Vec<2>, 4> control;  // [length]
};

using Stretch = std::variant<Straight, EllipseArc, Cubic>;

/// A chain of smooth stretches, each beginning where the one before ends, measured along its length.
class Curve {
 public:
  /// Makes a curve of one stretch at least.
  explicit Curve(std::vector<Stretch> stretches);

  double length() const { return begins_.back(); }  // [length]
  Vec<2> first() const;
  Vec<2> last() const;
  /// The place at arc length s from the first end, to 1e-12 of the length; s is cut to 0 .. length().
  Vec<2> at(double s) const;
  const std::vector<Stretch>& stretches() const { return stretches_; }

 private:
  std::vector<Stretch> stretches_;
  std::vector<double> begins_;  ///< arc length at which each stretch begins, and after them the whole one [length]
};

/// Straight lines between consecutive vertices, 2 at least.
Curve polyline(const std::vector<Vec<2>>& vertices);

/// From and to in degrees of the parameter, counter-clockwise from x; below `from` it runs clockwise.
Curve ellipse_arc(const Vec<2>& centre, double a, double b, double from, double to);

/// The cubic spline through 2 vertices or more, no two consecutive ones at one place. Its parameter is the chord
/// length, which keeps it free of loops where vertices stand at uneven distances. Its ends are natural (no curvature
/// there): a clamped one would need end slopes, which a deck has no place for. Where the last vertex is the first, to
/// 1e-9 of the chords' length, it closes smoothly: slope and curvature run through the seam.
Curve spline(const std::vector<Vec<2>>& vertices);

/// One after the other, as they stand.
Curve joined(const std::vector<Curve>& curves);

/// Distance between two places over which the ends of curves count as one, as a part of the whole length.
constexpr double same_place = 1e-9;

double distance(const Vec<2>& a, const Vec<2>& b);

/// Returns whether the last end meets the first one.
bool is_closed(const Curve& curve);

/// Ends at which a point must stand.
struct EndPoints {
  bool first = false, last = false;
};

/// Points along a curve at equal distances.
struct Seeds {
  std::vector<Vec<2>> places;  // [length]
  std::vector<double> pieces;  ///< what of the curve belongs to each point; they sum up to its length [length]
};

/// n >= 2 points at equal distances along the curve, each in the middle of its piece; a point at an end has only the
/// half piece on its inner side.
Seeds seeds(const Curve& curve, std::size_t n, EndPoints ends);

/// How many points stand at about `spacing` from each other: the nearest number for which a whole number of pieces fits
/// (two half pieces at end points make one). Not yet checked against any limit.
double seed_count(const Curve& curve, double spacing, EndPoints ends);

}  // namespace tether
