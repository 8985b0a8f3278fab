// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "grid/boxes.hpp"
#include "laws/walls.hpp"
#include "loops/points.hpp"

namespace tether::mpm {

/// Where the points of a scene stand [length], and which slots hold one: without numbers all do.
struct PlaceArrays {
  std::span<const double> x, y;
  std::span<const int> id = {};
  bool holds(std::size_t p) const { return id.empty() || id[p] >= 0; }
};

/// Unit tangents by point: those of before when a rule is asked, its own when it returns.
struct Tangents {
  std::span<double> x, y;
};

/// Turns the tangent of point p across the gradient of a colour, to the side of the tangent before. A gradient that is
/// not longer than `least` shows no direction: the tangent stays.
inline void turn_across(const Tangents& tangents, std::size_t p, Pair gradient, double least) {
  const double length = std::sqrt(gradient[0] * gradient[0] + gradient[1] * gradient[1]);
  if (!(length > least)) return;
  double& tx = tangents.x[p];
  double& ty = tangents.y[p];
  const double sign = ty * gradient[0] < tx * gradient[1] ? 1 : -1;
  tx = sign * gradient[1] / length, ty = -sign * gradient[0] / length;
}

/// What a kernel's numbers along an axis count. A wall runs through a node and beside a cell.
enum class AxisOf { cells, nodes };

/// Places of the numbers -1 .. count along one axis, times `stride`. Number `first` stands at the low wall, `last` at
/// the high one; what stands behind a wall that mirrors shares its image's place.
inline std::vector<std::size_t> folded_axis(AxisOf what, int count, int first, int last, bool mirror_low,
                                            bool mirror_high, std::size_t stride) {
  const int beside = what == AxisOf::cells ? 1 : 0;
  std::vector<std::size_t> place;
  for (int k = -1; k <= count; ++k) {
    const int image = mirror_low && k < first   ? 2 * first - beside - k
                      : mirror_high && k > last ? 2 * last + beside - k
                                                : k;
    place.push_back(static_cast<std::size_t>(image + 1) * stride);
  }
  return place;
}

/// Sums that are all zero after clear(), which costs nothing: a sum of an earlier round counts as zero.
template <class T>
class RoundSums {
 public:
  explicit RoundSums(std::size_t count) : sums_(count) {}
  void clear() { ++round_; }
  void add(std::size_t k, const T& value) {
    Sum& sum = sums_[k];
    if (sum.round != round_) sum = {T{}, round_};
    sum.value += value;
  }
  T operator[](std::size_t k) const { return sums_[k].round == round_ ? sums_[k].value : T{}; }

 private:
  struct Sum {
    T value{};
    std::uint64_t round = 0;
  };
  std::vector<Sum> sums_;
  std::uint64_t round_ = 0;
};

// Normals from a colour that points lend to the grid (7.1 to 7.3 of chapter 7). All points have the colour 1, those of
// the membrane and the others, of the fluid inside. Without fluid the colour has its ridge on the membrane, where its
// gradient vanishes but for the scatter of the points: that is why the results are then poor.

/// Shorter gradients of the colours of single points, times a cell's side, are rounding.
constexpr double least_color_slope = 1e-9;

/// Colour of cells by the quadratic kernel, and its gradient at nodes. Behind a wall that mirrors stands the image.
class CellColor {
 public:
  CellColor(const BackgroundGrid& shape, const Walls& walls);

  void clear() { color_.clear(); }
  void add(const PlaceArrays& places, std::size_t p);  // (7.4), (9.10)
  /// Node (i, j) of the grid; per length (7.5), (9.11).
  Pair gradient(int i, int j) const;
  /// Colours of the four cells around the node together.
  double around(int i, int j) const;

 private:
  double cell(int i, int j) const {
    const int column = i + 1, row = j + 1;  // -1 is behind the wall
    return color_[column_[static_cast<std::size_t>(column)] + row_[static_cast<std::size_t>(row)]];
  }

  Locator locator_;
  std::vector<std::size_t> column_, row_;
  RoundSums<double> color_;
};

/// Simple colour (7.2), (7.3): gradients of linear shape functions, summed at nodes.
class ColorNormals {
 public:
  ColorNormals(const BackgroundGrid& shape, const Walls& walls);
  void update(const PlaceArrays& places, Range membrane, std::span<const Slots> others, const Tangents& tangents);

 private:
  void add(const PlaceArrays& places, Slots range);
  Pair normal(int i, int j) const;

  Locator locator_;
  double least_;
  std::vector<double> sides_x_, sides_y_;  // of a node: 2 on a wall that mirrors, else 1
  RoundSums<Pair> sums_;
};

/// Quadratic colour of cells (7.4), its gradient at nodes (7.5), linear to the points (7.3).
class QuadraticNormals {
 public:
  QuadraticNormals(const BackgroundGrid& shape, const Walls& walls);
  void update(const PlaceArrays& places, Range membrane, std::span<const Slots> others, const Tangents& tangents);

 private:
  Locator locator_;
  double least_;
  CellColor color_;
};

/// Cubic colour of nodes (7.6) and the kernel's own gradient (7.7).
class CubicNormals {
 public:
  CubicNormals(const BackgroundGrid& shape, const Walls& walls);
  void update(const PlaceArrays& places, Range membrane, std::span<const Slots> others, const Tangents& tangents);

 private:
  void add(const PlaceArrays& places, Slots range);
  Pair gradient(const CellPlace& at) const;

  Locator locator_;
  double least_;
  std::vector<std::size_t> column_, row_;
  std::vector<double> sides_x_, sides_y_;  // of a place in column_ or row_: 2 on a wall that mirrors, else 1
  RoundSums<double> color_;
};

}  // namespace tether::mpm
