// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/elements_across.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "grid/element_sides.hpp"
#include "grid/jacobian.hpp"
#include "grid/lagrange.hpp"

namespace tether {
namespace {

using Vector = Eigen::Vector3d;

/// Part of the boundary that may be thinner than what counts as the thickness: corners and edges.
constexpr double thin_part = 0.1;

/// A way through a part: its length, the layers that it crosses, the area of the side where it begins.
struct Way {
  double length = 0, count = 0, area = 0;
};

/// Sides of all elements, `sides_per_element` each, and of each side the one of the neighbour, or -1.
class SideTable {
 public:
  explicit SideTable(const Mesh& mesh)
      : mesh_(mesh), per_side_(static_cast<std::size_t>(side_node_count_of(mesh.kind))) {
    for (std::size_t e = 0; e < mesh.element_count(); ++e) add_sides(mesh.kind, mesh.element(e), nodes_);
    beyond_.assign(count(), -1);
    std::map<std::vector<int>, std::size_t> open;
    for (std::size_t s = 0; s < count(); ++s) {
      std::vector<int> sorted(nodes(s), nodes(s) + per_side_);
      std::sort(sorted.begin(), sorted.end());
      const auto [other, first] = open.emplace(std::move(sorted), s);
      if (first) continue;
      beyond_[s] = static_cast<int>(other->second), beyond_[other->second] = static_cast<int>(s);
    }
  }
  std::size_t count() const { return nodes_.size() / per_side_; }
  std::size_t per_element() const { return count() / mesh_.element_count(); }
  std::size_t element_of(std::size_t side) const { return side / per_element(); }
  int beyond(std::size_t side) const { return beyond_[side]; }
  const int* nodes(std::size_t side) const { return &nodes_[side * per_side_]; }
  std::size_t per_side() const { return per_side_; }

 private:
  const Mesh& mesh_;
  std::size_t per_side_;
  Sides nodes_;
  std::vector<int> beyond_;
};

/// Walks from a side of the boundary to the opposite one.
class Walker {
 public:
  explicit Walker(const Mesh& mesh) : mesh_(mesh), dim_(static_cast<std::size_t>(mesh.dim())), sides_(mesh) {}

  const SideTable& sides() const { return sides_; }
  Way way_from(std::size_t side) const {
    Way way = is_simplex(mesh_.kind) ? straight(side) : from_side_to_side(side);
    way.area = area(side);
    return way;
  }

 private:
  Vector node(int n) const {
    Vector x = Vector::Zero();
    for (std::size_t i = 0; i < dim_; ++i)
      x[static_cast<Eigen::Index>(i)] = mesh_.x[static_cast<std::size_t>(n) * dim_ + i];
    return x;
  }
  Vector corner(std::size_t side, std::size_t k) const { return node(sides_.nodes(side)[k]); }
  Vector middle(std::size_t side) const {
    Vector sum = Vector::Zero();
    for (std::size_t k = 0; k < sides_.per_side(); ++k) sum += corner(side, k);
    return sum / static_cast<double>(sides_.per_side());
  }
  /// Twice the area of a side in space, along its normal; its length in the plane.
  Vector normal(std::size_t side) const {
    const Vector a = corner(side, 1) - corner(side, 0);
    if (dim_ == 2) return {a[1], -a[0], 0};
    if (sides_.per_side() == 3) return a.cross(corner(side, 2) - corner(side, 0));
    return (corner(side, 3) - corner(side, 0)).cross(corner(side, 2) - corner(side, 1));
  }
  double area(std::size_t side) const { return (dim_ == 2 ? 1 : 0.5) * normal(side).norm(); }

  /// Sides of a box stand in pairs, low and high along each axis.
  Way from_side_to_side(std::size_t side) const {
    Way way;
    int next = static_cast<int>(side);
    while (next >= 0 && way.count < static_cast<double>(mesh_.element_count())) {
      const auto in = static_cast<std::size_t>(next), out = in ^ std::size_t{1};
      way.length += (middle(out) - middle(in)).norm(), way.count += 1;
      next = sides_.beyond(out);
    }
    return way;
  }

  /// Of the functions 1 - sum s, s_1 .. of a simplex: values at x, and how they change along d.
  struct Barycentric {
    Eigen::Vector4d value = Eigen::Vector4d::Zero(), change = Eigen::Vector4d::Zero();
  };
  Barycentric barycentric(std::size_t e, const Vector& x, const Vector& d) const {
    const int* nodes = mesh_.element(e);
    const auto n = static_cast<Eigen::Index>(dim_);
    Eigen::Matrix3d J = Eigen::Matrix3d::Identity();
    for (Eigen::Index k = 0; k < n; ++k) J.col(k) = node(nodes[k + 1]) - node(nodes[0]);
    const Eigen::PartialPivLU<Eigen::Matrix3d> lu(J);
    Barycentric b;
    b.value.segment(1, n) = lu.solve(x - node(nodes[0])).head(n), b.change.segment(1, n) = lu.solve(d).head(n);
    b.value[0] = 1 - b.value.segment(1, n).sum(), b.change[0] = -b.change.segment(1, n).sum();
    return b;
  }
  /// The side of element e that lies opposite its corner a.
  std::size_t side_opposite(std::size_t e, Eigen::Index a) const {
    const int corner = mesh_.element(e)[a];
    std::size_t side = e * sides_.per_element();
    while (std::find(sides_.nodes(side), sides_.nodes(side) + sides_.per_side(), corner) !=
           sides_.nodes(side) + sides_.per_side())
      ++side;
    return side;
  }
  /// Where the way leaves an element, other than by the side where it came in.
  std::pair<std::size_t, double> exit(std::size_t in, const Vector& x, const Vector& d) const {
    const std::size_t e = sides_.element_of(in);
    const Barycentric b = barycentric(e, x, d);
    double least = std::numeric_limits<double>::infinity();
    std::size_t out = in;
    for (Eigen::Index a = 0; a <= static_cast<Eigen::Index>(dim_); ++a) {
      const std::size_t side = side_opposite(e, a);
      if (side == in || !(b.change[a] < 0)) continue;
      const double far = std::max(-b.value[a] / b.change[a], 0.0);
      if (far < least) least = far, out = side;
    }
    return {out, least};
  }
  /// From a place off the middle of the side, so that it goes through few corners.
  Way straight(std::size_t side) const {
    constexpr std::array<std::array<double, 3>, 2> parts{{{0.53, 0.47, 0}, {0.36, 0.31, 0.33}}};
    Vector x = Vector::Zero();
    for (std::size_t k = 0; k < dim_; ++k) x += parts[dim_ - 2][k] * corner(side, k);
    const Vector d = -normal(side).normalized();
    Way way;
    int next = static_cast<int>(side);
    double crossed = 0;
    while (next >= 0 && crossed < static_cast<double>(mesh_.element_count())) {
      const auto [out, far] = exit(static_cast<std::size_t>(next), x, d);
      if (!std::isfinite(far)) break;
      x += far * d, way.length += far, crossed += 1;
      next = sides_.beyond(out);
    }
    way.count = std::max(1.0, std::round(crossed / static_cast<double>(dim_)));
    return way;
  }

  const Mesh& mesh_;
  std::size_t dim_;
  SideTable sides_;
};

/// The thin direction: of the ways that are no longer than a tenth of the boundary has, the mean.
ElementsAcross thin_direction(std::vector<Way> ways) {
  std::sort(ways.begin(), ways.end(), [](const Way& a, const Way& b) { return a.length < b.length; });
  double whole = 0, area = 0, length = 0, count = 0;
  for (const Way& way : ways) whole += way.area;
  for (const Way& way : ways) {
    area += way.area, length += way.area * way.length, count += way.area * way.count;
    if (area >= thin_part * whole) break;
  }
  ElementsAcross across;
  across.thickness = length / area, across.count = std::round(count / area);
  return across;
}

double element_volume(const Mesh& mesh, std::size_t e) {
  return with_shapes(mesh.kind, [&](auto shapes) {
    using Shapes = decltype(shapes);
    double volume = 0;
    for (int k = 0; k < Shapes::points; ++k)
      volume += Shapes::weight(k) * std::abs(jacobian_at<Shapes>(mesh, e, Shapes::place(k)).determinant);
    return volume;
  });
}

/// What is left is the mean element: its volume and its extent across give its length.
void measure_elements(const Mesh& mesh, const std::vector<std::size_t>& elements, ElementsAcross& across) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  std::array<double, 3> low, high;
  low.fill(std::numeric_limits<double>::infinity()), high.fill(-std::numeric_limits<double>::infinity());
  double volume = 0;
  std::set<int> regions;
  for (const std::size_t e : elements) {
    volume += element_volume(mesh, e);
    regions.insert(mesh.region[e]);
    for (int a = 0; a < node_count_of(mesh.kind); ++a) {
      for (std::size_t i = 0; i < dim; ++i) {
        const double x = mesh.x[static_cast<std::size_t>(mesh.element(e)[a]) * dim + i];
        low[i] = std::min(low[i], x), high[i] = std::max(high[i], x);
      }
    }
  }
  for (std::size_t i = 0; i < dim; ++i) across.longest = std::max(across.longest, high[i] - low[i]);
  const double per_cell = !is_simplex(mesh.kind) ? 1 : dim == 2 ? 2 : 6;
  const double cell = per_cell * volume / static_cast<double>(elements.size());
  across.along = std::pow(cell * across.count / across.thickness, 1 / (static_cast<double>(dim) - 1));
  across.regions.assign(regions.begin(), regions.end());
}

}  // namespace

std::vector<ElementsAcross> elements_across(const Mesh& mesh) {
  if (order_of(mesh.kind) != 1 || mesh.element_count() == 0) return {};
  const std::vector<int> part = parts_of(mesh);
  const auto part_of = [&](std::size_t e) {
    return static_cast<std::size_t>(part[static_cast<std::size_t>(mesh.element(e)[0])]);
  };
  const Walker walker(mesh);
  std::vector<std::vector<Way>> ways(static_cast<std::size_t>(count_parts(mesh)));
  std::vector<std::vector<std::size_t>> elements(ways.size());
  for (std::size_t e = 0; e < mesh.element_count(); ++e) elements[part_of(e)].push_back(e);
  for (std::size_t s = 0; s < walker.sides().count(); ++s) {
    if (walker.sides().beyond(s) < 0) ways[part_of(walker.sides().element_of(s))].push_back(walker.way_from(s));
  }
  std::vector<ElementsAcross> all;
  for (std::size_t p = 0; p < ways.size(); ++p) {
    all.push_back(thin_direction(std::move(ways[p])));
    measure_elements(mesh, elements[p], all.back());
  }
  return all;
}

}  // namespace tether
