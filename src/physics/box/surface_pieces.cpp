// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/surface_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"

namespace tether::coupled {
namespace {

/// A corner of what is left of a side.
struct Corner {
  Vec<3> x{}, share{};
};

Corner between(const Corner& a, const Corner& b, double t) {
  Corner c;
  for (std::size_t i = 0; i < 3; ++i) {
    c.x[i] = (1 - t) * a.x[i] + t * b.x[i];
    c.share[i] = (1 - t) * a.share[i] + t * b.share[i];
  }
  return c;
}

/// A convex polygon; a triangle cut by three pairs of planes has no more corners than these.
struct Polygon {
  std::array<Corner, 12> corners;
  std::size_t size = 0;
  void add(const Corner& corner) { corners[size++] = corner; }
};

/// Returns what lies at sign (x - place) >= 0 along the axis (I. E. Sutherland and G. W. Hodgman, Comm. ACM 17 (1974)
/// 32-42).
Polygon clipped(const Polygon& polygon, std::size_t axis, double place, double sign) {
  Polygon left;
  for (std::size_t k = 0; k < polygon.size; ++k) {
    const Corner &a = polygon.corners[k], &b = polygon.corners[(k + 1) % polygon.size];
    const double da = sign * (a.x[axis] - place), db = sign * (b.x[axis] - place);
    if (da >= 0) left.add(a);
    if ((da > 0 && db < 0) || (da < 0 && db > 0)) {
      Corner cut = between(a, b, da / (da - db));
      cut.x[axis] = place;
      left.add(cut);
    }
  }
  return left;
}

class Cutter {
 public:
  Cutter(const StaggeredGrid& grid, int per_cell, SurfacePieces& out) : grid_(grid), per_cell_(per_cell), out_(out) {}

  void cut_edge(int side, const Corner& a, const Corner& b) {
    ends_.assign({0.0, 1.0});
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double low = std::min(a.x[axis], b.x[axis]), high = std::max(a.x[axis], b.x[axis]);
      for (int k = box_of(axis, low) + 1; plane(axis, k) < high; ++k) {
        if (plane(axis, k) > low) ends_.push_back((plane(axis, k) - a.x[axis]) / (b.x[axis] - a.x[axis]));
      }
    }
    std::sort(ends_.begin(), ends_.end());
    for (std::size_t k = 0; k + 1 < ends_.size(); ++k) {
      if (ends_[k + 1] > ends_[k]) add_segment(side, a, b, ends_[k], ends_[k + 1]);
    }
  }

  void cut_polygon(int side, const Polygon& polygon, std::size_t axis) {
    if (axis == 3) return add_polygon(side, polygon);
    double low = polygon.corners[0].x[axis], high = low;
    for (std::size_t k = 1; k < polygon.size; ++k) {
      low = std::min(low, polygon.corners[k].x[axis]), high = std::max(high, polygon.corners[k].x[axis]);
    }
    Polygon rest = polygon;
    for (int k = box_of(axis, low) + 1; plane(axis, k) < high; ++k) {
      const Polygon below = clipped(rest, axis, plane(axis, k), -1);
      if (below.size > 2) cut_polygon(side, below, axis + 1);
      rest = clipped(rest, axis, plane(axis, k), 1);
    }
    if (rest.size > 2) cut_polygon(side, rest, axis + 1);
  }

 private:
  double plane(std::size_t axis, int k) const { return grid_.low[axis] + k * (grid_.d[axis] / per_cell_); }
  int box_of(std::size_t axis, double x) const {
    return static_cast<int>(std::floor((x - grid_.low[axis]) / grid_.d[axis] * per_cell_));
  }

  /// Two points of Gauss.
  void add_segment(int side, const Corner& a, const Corner& b, double from, double to) {
    constexpr double gauss = 0.21132486540518711775;
    begin(side);
    for (const double s : {gauss, 1 - gauss}) add(between(a, b, from + s * (to - from)), 0.5 * (to - from));
    finish();
  }

  /// Triangles about the first corner, with three points each.
  void add_polygon(int side, const Polygon& polygon) {
    begin(side);
    for (std::size_t k = 1; k + 1 < polygon.size; ++k) {
      const Corner &a = polygon.corners[0], &b = polygon.corners[k], &c = polygon.corners[k + 1];
      const double part = part_of(a.share, b.share, c.share);
      if (part == 0) continue;
      for (const auto& w : {Vec<3>{4, 1, 1}, Vec<3>{1, 4, 1}, Vec<3>{1, 1, 4}}) {
        Corner point;
        for (std::size_t i = 0; i < 3; ++i) {
          point.x[i] = (w[0] * a.x[i] + w[1] * b.x[i] + w[2] * c.x[i]) / 6;
          point.share[i] = (w[0] * a.share[i] + w[1] * b.share[i] + w[2] * c.share[i]) / 6;
        }
        add(point, part / 3);
      }
    }
    finish();
  }
  static double part_of(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c) {
    return std::abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  }

  void begin(int side) { out_.pieces.push_back({side, out_.points.size(), 0, {}, {}}), weight_ = 0; }
  void add(const Corner& corner, double part) {
    out_.points.push_back({corner.x, corner.share, part});
    SurfacePiece& piece = out_.pieces.back();
    for (std::size_t i = 0; i < 3; ++i) piece.middle[i] += part * corner.x[i];
    weight_ += part, ++piece.count;
  }
  void finish() {
    SurfacePiece& piece = out_.pieces.back();
    if (piece.count == 0) return out_.pieces.pop_back();
    for (std::size_t i = 0; i < 3; ++i) {
      piece.middle[i] /= weight_;
      piece.cell[i] = static_cast<int>(std::floor((piece.middle[i] - grid_.low[i]) / grid_.d[i]));
    }
    if (grid_.dim == 2) piece.cell[2] = 0;
  }

  const StaggeredGrid& grid_;
  int per_cell_;
  SurfacePieces& out_;
  double weight_ = 0;
  std::vector<double> ends_;
};

}  // namespace

SurfacePieces cut_surface(const SolidSurface& surface, std::span<const double> q, const StaggeredGrid& grid,
                          int per_cell) {
  SurfacePieces out;
  out.area = areas_of_sides(surface, q);
  Cutter cutter(grid, per_cell, out);
  for (std::size_t s = 0; s < surface.side_count(); ++s) {
    std::array<Corner, 3> corners;
    for (int a = 0; a < surface.dim; ++a) {
      corners[at(a)].x = place_of(q, surface.side(s)[at(a)], surface.dim);
      corners[at(a)].share[at(a)] = 1;
    }
    if (surface.dim == 2) {
      cutter.cut_edge(static_cast<int>(s), corners[0], corners[1]);
    } else {
      Polygon whole;
      for (const Corner& corner : corners) whole.add(corner);
      cutter.cut_polygon(static_cast<int>(s), whole, 0);
    }
  }
  return out;
}

}  // namespace tether::coupled
