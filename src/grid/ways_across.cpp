// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/ways_across.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "grid/mesh.hpp"
#include "grid/shapes.hpp"

namespace tether {
namespace {

using Vector = Eigen::Vector3d;

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

/// Least cosine between a way and the normal of a side that lies opposite: 26 degrees. By less a way has cut a corner.
constexpr double opposite = 0.9;

/// Walks from a side of the boundary to the opposite one.
class Walker {
 public:
  explicit Walker(const Mesh& mesh) : mesh_(mesh), dim_(static_cast<std::size_t>(mesh.dim())), sides_(mesh) {}

  const SideTable& sides() const { return sides_; }
  Way way_from(std::size_t side) const {
    Way way = is_simplex(mesh_.kind) ? straight(side) : from_side_to_side(side);
    way.element = sides_.element_of(side), way.side = static_cast<int>(side), way.area = area(side);
    return way;
  }
  /// Returns the normal of a side of the boundary, out of the body.
  Vector outward(std::size_t side) const { return normal(side).normalized(); }

 private:
  Vector node(int n) const {
    Vector x = Vector::Zero();
    for (std::size_t i = 0; i < dim_; ++i)
      x[static_cast<Eigen::Index>(i)] = mesh_.x[static_cast<std::size_t>(n) * dim_ + i];
    return x;
  }
  Vector corner(std::size_t side, std::size_t k) const { return node(sides_.nodes(side)[k]); }
  /// Twice the area of a side in space, along its normal; its length in the plane.
  Vector normal(std::size_t side) const {
    const Vector a = corner(side, 1) - corner(side, 0);
    if (dim_ == 2) return {a[1], -a[0], 0};
    if (sides_.per_side() == 3) return a.cross(corner(side, 2) - corner(side, 0));
    return (corner(side, 3) - corner(side, 0)).cross(corner(side, 2) - corner(side, 1));
  }
  double area(std::size_t side) const { return (dim_ == 2 ? 1 : 0.5) * normal(side).norm(); }

  Vector middle(std::size_t side) const {
    Vector sum = Vector::Zero();
    for (std::size_t k = 0; k < sides_.per_side(); ++k) sum += corner(side, k);
    return sum / static_cast<double>(sides_.per_side());
  }

  /// Sides of a box stand in pairs, low and high along each axis. Between the sides where it begins and ends a way is
  /// as long as they are apart at right angles to both; one that turns about, which has no such direction, as it is.
  Way from_side_to_side(std::size_t side) const {
    constexpr double turned = 1;  // sum of two unit normals that are 120 degrees apart
    Way way;
    int next = static_cast<int>(side);
    std::size_t last = side;
    while (next >= 0 && way.layers < static_cast<double>(mesh_.element_count())) {
      const auto in = static_cast<std::size_t>(next);
      last = in ^ std::size_t{1};
      way.length += (middle(last) - middle(in)).norm(), way.layers += 1;
      next = sides_.beyond(last);
    }
    const Vector across = outward(last) - outward(side);
    if (across.norm() > turned) way.length = (middle(last) - middle(side)).dot(across.normalized());
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
  /// Returns where the way leaves an element, other than by the side where it came in.
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
    std::size_t last = side;
    double crossed = 0;
    while (next >= 0 && crossed < static_cast<double>(mesh_.element_count())) {
      const auto [out, far] = exit(static_cast<std::size_t>(next), x, d);
      if (!std::isfinite(far)) break;
      x += far * d, way.length += far, crossed += 1;
      next = sides_.beyond(out), last = out;
    }
    way.opposed = d.dot(outward(last)) >= opposite;
    way.layers = std::max(1.0, std::round(crossed / static_cast<double>(dim_)));
    return way;
  }

  const Mesh& mesh_;
  std::size_t dim_;
  SideTable sides_;
};

/// Counts edges from a side to the nodes of the boundary that lie opposite.
class EdgeCount {
 public:
  EdgeCount(const Mesh& mesh, const Walker& walker)
      : sides_(walker.sides()), walker_(walker), next_(mesh.node_count()), outward_(mesh.node_count()) {
    const int per_element = node_count_of(mesh.kind);
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      for (int a = 0; a < per_element; ++a) {
        for (int b = 0; b < per_element; ++b) {
          if (a != b) next_[static_cast<std::size_t>(mesh.element(e)[a])].push_back(mesh.element(e)[b]);
        }
      }
    }
    for (std::size_t s = 0; s < sides_.count(); ++s) {
      if (sides_.beyond(s) >= 0) continue;
      for (std::size_t k = 0; k < sides_.per_side(); ++k)
        outward_[static_cast<std::size_t>(sides_.nodes(s)[k])].push_back(walker.outward(s));
    }
  }
  /// 0 where none lies opposite.
  double from(std::size_t side) const {
    const Vector into = -walker_.outward(side);
    std::vector<int> reached(sides_.nodes(side), sides_.nodes(side) + sides_.per_side());
    std::vector<int> edges(next_.size(), -1);
    for (const int n : reached) edges[static_cast<std::size_t>(n)] = 0;
    for (std::size_t k = 0; k < reached.size(); ++k) {
      const auto n = static_cast<std::size_t>(reached[k]);
      if (lies_opposite(n, into)) return edges[n];
      for (const int other : next_[n]) {
        int& count = edges[static_cast<std::size_t>(other)];
        if (count < 0) count = edges[n] + 1, reached.push_back(other);
      }
    }
    return 0;
  }

 private:
  bool lies_opposite(std::size_t n, const Vector& into) const {
    return std::ranges::any_of(outward_[n], [&](const Vector& out) { return into.dot(out) >= opposite; });
  }
  const SideTable& sides_;
  const Walker& walker_;
  std::vector<std::vector<int>> next_;        // of each node, those that share an element
  std::vector<std::vector<Vector>> outward_;  // of each node, normals of its sides on the boundary
};

}  // namespace

double volume_of_element(const Mesh& mesh, std::size_t e) {
  return with_shapes(mesh.kind, [&](auto shapes) {
    using Shapes = decltype(shapes);
    double volume = 0;
    for (int k = 0; k < Shapes::points; ++k)
      volume += Shapes::weight(k) * std::abs(jacobian_at<Shapes>(mesh, e, Shapes::place(k)).determinant);
    return volume;
  });
}

std::vector<Way> ways_across(const Mesh& mesh) {
  const Walker walker(mesh);
  std::vector<Way> ways;
  for (std::size_t s = 0; s < walker.sides().count(); ++s) {
    if (walker.sides().beyond(s) < 0) ways.push_back(walker.way_from(s));
  }
  return ways;
}

std::vector<double> layers_across(const Mesh& mesh, const std::vector<Way>& ways) {
  const Walker walker(mesh);
  const EdgeCount edges(mesh, walker);
  std::vector<double> layers;
  for (const Way& way : ways) {
    const double found = edges.from(static_cast<std::size_t>(way.side));
    layers.push_back(found > 0 ? found : way.layers);
  }
  return layers;
}

}  // namespace tether
