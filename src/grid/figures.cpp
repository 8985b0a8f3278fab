// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/figures.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "base/numbers.hpp"

namespace tether {
namespace {

bool has(const Box<3>& box, const Vec<3>& x) { return box.contains(x); }

bool has(const Ellipsoid& ellipsoid, const Vec<3>& x) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double part = ellipsoid.half[i] > 0 ? (x[i] - ellipsoid.middle[i]) / ellipsoid.half[i] : 0;
    sum += part * part;
  }
  return sum <= 1;
}

bool has(const Prism& prism, const Vec<3>& x) { return prism.base.contains(x[0], x[1]); }

bool has(const HalfSpace& half, const Vec<3>& x) { return dot(minus(x, half.place), half.normal) <= 0; }

}  // namespace

bool contains(const Figure& figure, const Vec<3>& x) {
  return std::visit([&](const auto& of) { return has(of, x); }, figure);
}

/// The ellipsoid has a place of the box where it has that which is nearest to it in units of its half axes.
bool meet(const Ellipsoid& ellipsoid, const Box<3>& box) {
  Vec<3> nearest{};
  for (std::size_t i = 0; i < 3; ++i) nearest[i] = std::clamp(ellipsoid.middle[i], box.low[i], box.high[i]);
  return has(ellipsoid, nearest);
}

/// In units of half axes one is a ball of radius 1 about 0, the other has the middle m and the half axes b. Its place y
/// nearest to 0 has y_i = s m_i / (b_i^2 + s) with the s > 0 for which sum ((y_i - m_i) / b_i)^2 = 1.
bool meet(const Ellipsoid& one, const Ellipsoid& other) {
  if (has(one, other.middle) || has(other, one.middle)) return true;
  Vec<3> m{}, b{};
  for (std::size_t i = 0; i < 3; ++i)
    m[i] = (other.middle[i] - one.middle[i]) / one.half[i], b[i] = other.half[i] / one.half[i];
  const auto is_outside = [&](double s) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += std::pow(b[i] * m[i] / (b[i] * b[i] + s), 2);
    return sum > 1;
  };
  double low = 0, high = 1;
  while (is_outside(high)) high *= 2;
  for (int k = 0; k < 100; ++k) (is_outside(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
  double distance = 0;
  for (std::size_t i = 0; i < 3; ++i) distance += std::pow(high * m[i] / (b[i] * b[i] + high), 2);
  return distance <= 1;
}

namespace {

constexpr double beyond = 2;          // cells past the box, where what has no end ends
constexpr double off_surface = 1e-3;  // cells between a curved figure and its facets

/// Puts a surface together.
class Builder {
 public:
  explicit Builder(int dim) : dim_(dim) {}

  int node(const Vec<3>& x) {
    surface_.x.insert(surface_.x.end(), x.begin(), x.begin() + dim_);
    return static_cast<int>(surface_.x.size() / at(dim_)) - 1;
  }
  void edge(int a, int b) { surface_.sides.insert(surface_.sides.end(), {a, b}); }
  void triangle(int a, int b, int c) { surface_.sides.insert(surface_.sides.end(), {a, b, c}); }

  /// A polygon of the plane, its corners counter-clockwise.
  void polygon(const std::vector<Vec<3>>& corners) {
    const int first = count();
    for (const Vec<3>& x : corners) node(x);
    for (int k = 0; k < static_cast<int>(corners.size()); ++k)
      edge(first + k, first + (k + 1) % static_cast<int>(corners.size()));
  }
  /// A prism between two polygons that have the same corners but for the axis across them, counter-clockwise as seen
  /// from the upper one. Its ends are fans, parts of which may be turned over: what they enclose is right.
  void prism(const std::vector<Vec<3>>& low, const std::vector<Vec<3>>& high) {
    const int n = static_cast<int>(low.size()), first = count();
    for (const Vec<3>& x : low) node(x);
    for (const Vec<3>& x : high) node(x);
    for (int k = 0; k < n; ++k) {
      const int a = first + k, b = first + (k + 1) % n;
      triangle(a, b, b + n), triangle(a, b + n, a + n);
    }
    for (int k = 1; k + 1 < n; ++k) {
      triangle(first, first + k + 1, first + k);
      triangle(first + n, first + n + k, first + n + k + 1);
    }
  }
  FigureSurface take() { return std::move(surface_); }
  int count() const { return static_cast<int>(surface_.x.size() / at(dim_)); }

 private:
  int dim_;
  FigureSurface surface_;
};

double signed_area(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t k = 0, before = polygon.x.size() - 1; k < polygon.x.size(); before = k++)
    twice += polygon.x[before] * polygon.y[k] - polygon.x[k] * polygon.y[before];
  return 0.5 * twice;
}

FigureSurface surface(const Prism& prism, int dim, const Box<3>& box, double cell) {
  std::vector<Vec<3>> low, high;
  for (std::size_t k = 0; k < prism.base.x.size(); ++k) {
    low.push_back({prism.base.x[k], prism.base.y[k], box.low[2] - beyond * cell});
    high.push_back({prism.base.x[k], prism.base.y[k], box.high[2] + beyond * cell});
  }
  if (signed_area(prism.base) < 0) std::reverse(low.begin(), low.end()), std::reverse(high.begin(), high.end());
  Builder builder(dim);
  dim == 2 ? builder.polygon(low) : builder.prism(low, high);
  return builder.take();
}

FigureSurface surface(const Box<3>& of, int dim, const Box<3>&, double) {
  const auto layer = [&](double z) {
    return std::vector<Vec<3>>{
        {of.low[0], of.low[1], z}, {of.high[0], of.low[1], z}, {of.high[0], of.high[1], z}, {of.low[0], of.high[1], z}};
  };
  Builder builder(dim);
  dim == 2 ? builder.polygon(layer(0)) : builder.prism(layer(of.low[2]), layer(of.high[2]));
  return builder.take();
}

/// A block on the far side of the plane, so large that the box does not see its other faces.
FigureSurface surface(const HalfSpace& half, int dim, const Box<3>& box, double cell) {
  Vec<3> middle{};
  double size = 2 * beyond * cell;
  for (std::size_t i = 0; i < at(dim); ++i) {
    middle[i] = 0.5 * (box.low[i] + box.high[i]);
    size += box.high[i] - box.low[i];
  }
  const double off = dot(minus(middle, half.place), half.normal);
  const Vec<3>& n = half.normal;
  const Vec<3> along = dim == 2                                      ? Vec<3>{n[1], -n[0], 0}
                       : std::abs(n[0]) > 0.5 * std::sqrt(dot(n, n)) ? cross(n, Vec<3>{0, 1, 0})
                                                                     : cross(n, Vec<3>{1, 0, 0});
  const double length = std::sqrt(dot(along, along));
  const Vec<3> s{along[0] / length, along[1] / length, along[2] / length}, t = cross(n, s);
  const auto corner = [&](double by_s, double by_t, double by_n) {
    Vec<3> x{};
    for (std::size_t i = 0; i < 3; ++i)
      x[i] = middle[i] + size * (by_s * s[i] + by_t * t[i]) + (by_n * size - off) * n[i];
    return x;
  };
  Builder builder(dim);
  if (dim == 2) {  // n, s: s is n turned clockwise
    builder.polygon({corner(-1, 0, 0), corner(-1, 0, -3), corner(1, 0, -3), corner(1, 0, 0)});
  } else {
    const auto layer = [&](double by_n) {
      return std::vector<Vec<3>>{corner(-1, -1, by_n), corner(1, -1, by_n), corner(1, 1, by_n), corner(-1, 1, by_n)};
    };
    builder.prism(layer(-3), layer(0));
  }
  return builder.take();
}

/// A ball of radius 1: an octahedron whose edges are halved so often that its facets lie near enough.
FigureSurface ball(double largest, double cell) {
  Builder builder(3);
  std::vector<Vec<3>> x{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<std::array<int, 3>> facets{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                         {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (double edge = std::sqrt(2.0); edge * edge * largest / 8 > 2 * off_surface * cell; edge /= 2) {
    std::map<std::array<int, 2>, int> between;
    const auto halved = [&](int a, int b) {
      const auto [known, is_new] =
          between.emplace(std::array{std::min(a, b), std::max(a, b)}, static_cast<int>(x.size()));
      if (is_new) {
        Vec<3> m{};
        for (std::size_t i = 0; i < 3; ++i) m[i] = x[at(a)][i] + x[at(b)][i];
        const double length = std::sqrt(dot(m, m));
        x.push_back({m[0] / length, m[1] / length, m[2] / length});
      }
      return known->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : facets) {
      const int ab = halved(a, b), bc = halved(b, c), ca = halved(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    facets.swap(finer);
  }
  for (const Vec<3>& place : x) builder.node(place);
  for (const auto& [a, b, c] : facets) builder.triangle(a, b, c);
  return builder.take();
}

FigureSurface circle(double largest, double cell) {
  Builder builder(2);
  const int n =
      std::max(24, static_cast<int>(std::ceil(std::numbers::pi * std::sqrt(largest / (2 * off_surface * cell)))));
  std::vector<Vec<3>> corners;
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * std::numbers::pi * k / n;
    corners.push_back({std::cos(angle), std::sin(angle), 0});
  }
  builder.polygon(corners);
  return builder.take();
}

/// What facets of a circle or a ball about the origin enclose.
double enclosed(const FigureSurface& surface, int dim) {
  double sum = 0;
  const auto place = [&](int node) {
    const double* x = surface.x.data() + at(node) * at(dim);
    return Vec<3>{x[0], x[1], dim == 3 ? x[2] : 0};
  };
  for (std::size_t k = 0; k < surface.sides.size(); k += at(dim)) {
    const Vec<3> a = place(surface.sides[k]), b = place(surface.sides[k + 1]);
    sum += dim == 2 ? cross(a, b)[2] / 2 : dot(a, cross(b, place(surface.sides[k + 2]))) / 6;
  }
  return sum;
}

FigureSurface surface(const Ellipsoid& of, int dim, const Box<3>&, double cell) {
  const double largest = *std::max_element(of.half.begin(), of.half.begin() + dim);
  FigureSurface unit = dim == 2 ? circle(largest, cell) : ball(largest, cell);
  const double whole = dim == 2 ? std::numbers::pi : 4 * std::numbers::pi / 3,
               larger = std::pow(whole / enclosed(unit, dim), 1.0 / dim);
  for (std::size_t k = 0; k < unit.x.size(); ++k) {
    const std::size_t i = k % at(dim);
    unit.x[k] = of.middle[i] + larger * of.half[i] * unit.x[k];
  }
  return unit;
}

}  // namespace

FigureSurface surface_of(const Figure& figure, int dim, const Box<3>& box, double cell) {
  return std::visit([&](const auto& of) { return surface(of, dim, box, cell); }, figure);
}

}  // namespace tether
