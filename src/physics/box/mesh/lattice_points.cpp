// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/lattice_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "base/numbers.hpp"

namespace tether::coupled {
namespace {

constexpr double apart = 0.6;  // of the size, from the outline and from points of other lattices
constexpr int most_levels = 12;

/// Points in square bins.
class Bins {
 public:
  Bins(const Vec<3>& low, const Vec<3>& high, double width) : low_(low), width_(width) {
    for (std::size_t a = 0; a < 2; ++a)
      n_[a] = std::max(1, static_cast<int>(std::ceil((high[a] - low[a]) / width)) + 1);
    first_.resize(at(n_[0]) * at(n_[1]));
  }
  void add(const Vec<3>& x, double size) { first_[at(bin(x, 0)) + at(n_[0]) * at(bin(x, 1))].push_back({x, size}); }

  struct Point {
    Vec<3> x;
    double size;
  };
  std::array<int, 2> count() const { return n_; }
  Vec<3> corner(int i, int j) const { return {low_[0] + i * width_, low_[1] + j * width_, 0}; }
  /// Calls f(point) for those in the bins within a reach of a place.
  template <class Function>
  void each_within(const Vec<3>& x, double reach, const Function& f) const {
    const auto from = [&](std::size_t a) { return bin({x[0] - reach, x[1] - reach, 0}, a); };
    const auto to = [&](std::size_t a) { return bin({x[0] + reach, x[1] + reach, 0}, a); };
    for (int j = from(1); j <= to(1); ++j) {
      for (int i = from(0); i <= to(0); ++i) {
        for (const Point& point : first_[at(i) + at(n_[0]) * at(j)]) f(point);
      }
    }
  }

 private:
  int bin(const Vec<3>& x, std::size_t a) const {
    return std::clamp(static_cast<int>((x[a] - low_[a]) / width_), 0, n_[a] - 1);
  }

  Vec<3> low_;
  double width_;
  std::array<int, 2> n_{};
  std::vector<std::vector<Point>> first_;
};

double distance(const Vec<3>& a, const Vec<3>& b) {
  return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]));
}

/// The size that a mesh is to have about an outline.
class SizesAbout {
 public:
  double least;      ///< of the segments
  Vec<3> low, high;  ///< the outline's extent

  SizesAbout(const PlaneOutline& outline, const MeshSizes& sizes) : least(sizes.size), sizes_(sizes) {
    constexpr double far = std::numeric_limits<double>::max();
    low = {far, far, 0}, high = {-far, -far, 0};
    for (const Vec<3>& x : outline.places) {
      for (std::size_t a = 0; a < 2; ++a) low[a] = std::min(low[a], x[a]), high[a] = std::max(high[a], x[a]);
    }
    along_.emplace(low, high, sizes.size);
    for (const PlaneOutline::Segment& segment : outline.segments)
      add(outline.places[segment.ends[0]], outline.places[segment.ends[1]]);
  }

  const Bins& bins() const { return *along_; }
  /// Returns a size that none in a bin is below.
  double least_in(int i, int j) const {
    const Vec<3> low_corner = along_->corner(i, j);
    const double half = 0.5 * sizes_.size;
    const Vec<3> middle{low_corner[0] + half, low_corner[1] + half, 0};
    double size = sizes_.size;
    along_->each_within(middle, half + sizes_.size / sizes_.growth, [&](const Bins::Point& point) {
      const double way = std::max(0.0, distance(middle, point.x) - std::sqrt(2.0) * half);
      size = std::min(size, point.size + sizes_.growth * way);
    });
    return size;
  }
  /// Returns the size at a place; 0 where that is too near to the outline.
  double size_at(const Vec<3>& x) const {
    double size = sizes_.size, nearest = std::numeric_limits<double>::max();
    along_->each_within(x, sizes_.size / sizes_.growth, [&](const Bins::Point& point) {
      const double way = distance(x, point.x);
      size = std::min(size, point.size + sizes_.growth * way), nearest = std::min(nearest, way);
    });
    return nearest < apart * size ? 0 : size;
  }

 private:
  void add(const Vec<3>& a, const Vec<3>& b) {
    const double length = distance(a, b), size = std::min(length, sizes_.size);
    if (length == 0) return;
    least = std::min(least, size);
    const int parts = std::max(1, static_cast<int>(std::ceil(4 * length / size)));
    for (int k = 0; k < parts; ++k) {
      const double s = (k + 0.5) / parts;
      along_->add({a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1]), 0}, size);
    }
  }

  const MeshSizes& sizes_;
  std::optional<Bins> along_;  // places along the segments, with their lengths as sizes
};

}  // namespace

std::vector<Vec<3>> lattice_points(const PlaneOutline& outline, const MeshSizes& sizes) {
  const SizesAbout about(outline, sizes);
  const Vec<3>&low = about.low, &high = about.high;
  const int levels = std::min(most_levels, static_cast<int>(std::ceil(std::log2(sizes.size / about.least) - 0.5)));
  Bins taken(low, high, sizes.size);
  std::vector<Vec<3>> points;
  std::vector<double> least;  // of each bin
  const std::array<int, 2> bins = about.bins().count();
  for (int j = 0; j < bins[1]; ++j) {
    for (int i = 0; i < bins[0]; ++i) least.push_back(about.least_in(i, j));
  }
  for (int level = 0; level <= levels; ++level) {
    const double step = sizes.size * std::pow(0.5, level);
    const int rows = std::max(1, static_cast<int>(std::round((high[1] - low[1]) / (step * std::sqrt(0.75)))));
    const double apart_rows = (high[1] - low[1]) / rows;
    const auto take = [&](int i, int j) {
      const Vec<3> x{low[0] + (i + (j % 2 == 0 ? 0 : 0.5)) * step, low[1] + apart_rows * j, 0};
      const double size = about.size_at(x);
      const bool coarser = size > step * std::sqrt(2.0) && level > 0, finer = size <= step * std::sqrt(0.5);
      if (size == 0 || x[0] > high[0] || coarser || (finer && level < levels)) return;
      bool free = true;
      taken.each_within(x, apart * size, [&](const Bins::Point& point) {
        free = free && (point.size == step || distance(x, point.x) >= apart * size);
      });
      if (free) taken.add(x, step), points.push_back(x);
    };
    for (std::size_t bin = 0; bin < least.size(); ++bin) {
      if (level > 0 && least[bin] > step * std::sqrt(2.0)) continue;
      const int column = static_cast<int>(bin) % bins[0], row = static_cast<int>(bin) / bins[0];
      const auto range = [&](int k, double spacing) {  // of lattice points from the bin's lower end on
        return static_cast<int>(std::ceil(k * sizes.size / spacing));
      };
      for (int j = range(row, apart_rows); j < std::min(range(row + 1, apart_rows), rows + 1); ++j) {
        for (int i = range(column, step); i < range(column + 1, step); ++i) take(i, j);
      }
    }
  }
  return points;
}

}  // namespace tether::coupled
