// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/crossings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers.hpp"

namespace tether {
namespace {

/// Follows A. Van Oosterom and J. Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125-126.
double solid_angle(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c) {
  const double la = std::sqrt(dot(a, a)), lb = std::sqrt(dot(b, b)), lc = std::sqrt(dot(c, c));
  return 2 * std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

}  // namespace

double turns_about(const SolidSurface& surface, std::span<const double> q, const Vec<3>& x, int but_part) {
  double angle = 0;
  std::array<Vec<3>, 3> to{};
  for (std::size_t s = 0; s < surface.side_count(); ++s) {
    if (surface.part[s] == but_part) continue;
    const auto nodes = surface.side(s);
    for (std::size_t a = 0; a < nodes.size(); ++a) to[a] = minus(place_of(q, nodes[a], surface.dim), x);
    angle +=
        surface.dim == 2 ? std::atan2(cross(to[0], to[1])[2], dot(to[0], to[1])) : solid_angle(to[0], to[1], to[2]);
  }
  return angle / (surface.dim == 2 ? 2 * std::numbers::pi : 4 * std::numbers::pi);
}

namespace {

/// Twice the area that the edge from node i to node j and a point span in the plane of axes b, c: taken from the lower
/// node's end, so that both sides of a surface that share the edge find the same number, with opposite signs. A point
/// on an edge or a node counts as if it lay a little farther along b, and much less along c: of the sides about it just
/// those have it that would have it there (H. Edelsbrunner and E. P. Muecke, ACM Trans. Graphics 9 (1990) 66-104).
struct EdgeSide {
  double twice_area = 0;
  bool left = false;
};
EdgeSide side_of_edge(int i, const Vec<3>& x, int j, const Vec<3>& y, std::size_t b, std::size_t c, double pb,
                      double pc) {
  const bool turned = j < i;
  const Vec<3>&from = turned ? y : x, &to = turned ? x : y;
  const double along_b = to[b] - from[b], along_c = to[c] - from[c];
  const double area = along_b * (pc - from[c]) - along_c * (pb - from[b]);
  const bool left = area != 0 ? area > 0 : along_c != 0 ? along_c < 0 : along_b > 0;
  return {turned ? -area : area, left != turned};
}

class Sweep {
 public:
  Sweep(const SolidSurface& surface, std::span<const double> q, const StaggeredGrid& grid, int axis, Crossings& out)
      : surface_(surface), q_(q), grid_(grid), axis_(at(axis)), b_((axis_ + 1) % 3), c_((axis_ + 2) % 3), out_(out) {
    if (surface.dim == 2) b_ = 1 - axis_, c_ = 2;
    out.lowest[axis_].assign(grid.face_count(axis), -1);
    out.highest[axis_].assign(grid.face_count(axis), -1);
    turns_.assign(grid.face_count(axis), 0);
    outer_turns_ = turns_;
  }

  void run() {
    for (std::size_t s = 0; s < surface_.side_count(); ++s) surface_.dim == 2 ? cross_edge(s) : cross_triangle(s);
  }

  /// Marks by how often the lines have entered a solid before each cell's middle, and how often what outer sheets
  /// enclose.
  void mark_inside() {
    out_.inside.assign(grid_.cell_count(), 0);
    out_.in_cavity.assign(grid_.cell_count(), 0);
    for (int k = 0; k < grid_.n[2]; ++k) {
      for (int j = 0; j < grid_.n[1]; ++j) {
        int solid = 0, outer = 0;
        for (int i = 0; i < grid_.n[0]; ++i) {
          solid += turns_[grid_.face(0, i, j, k)], outer += outer_turns_[grid_.face(0, i, j, k)];
          out_.inside[grid_.cell(i, j, k)] = static_cast<std::uint8_t>(std::clamp(solid, 0, 255));
          out_.in_cavity[grid_.cell(i, j, k)] = outer > 0 && solid <= 0 ? 1 : 0;
        }
      }
    }
  }

 private:
  /// The first line at or after a place along an axis across the lines.
  int line_behind(std::size_t axis, double x) const {
    return std::clamp(static_cast<int>(std::ceil((x - grid_.low[axis]) / grid_.d[axis] - 0.5)) - 1, 0, grid_.n[axis]);
  }

  void cross_edge(std::size_t s) {
    const auto nodes = surface_.side(s);
    const Vec<3> x = place_of(q_, nodes[0], 2), y = place_of(q_, nodes[1], 2);
    const double low = std::min(x[b_], y[b_]), high = std::max(x[b_], y[b_]);
    for (int j = line_behind(b_, low); j < grid_.n[b_]; ++j) {
      const double line = grid_.middle(static_cast<int>(b_), j);
      if (line > high) break;
      if ((x[b_] <= line) == (y[b_] <= line)) continue;
      const double t = (line - x[b_]) / (y[b_] - x[b_]);
      std::array<int, 3> place{};
      place[b_] = j;
      const Vec<3> normal{y[1] - x[1], -(y[0] - x[0]), 0};
      add(s, {1 - t, t, 0}, (1 - t) * x[axis_] + t * y[axis_], normal[axis_] < 0 ? 1 : -1, place);
    }
  }

  void cross_triangle(std::size_t s) {
    const auto nodes = surface_.side(s);
    std::array<Vec<3>, 3> x;
    for (std::size_t a = 0; a < 3; ++a) x[a] = place_of(q_, nodes[a], 3);
    const auto [low_b, high_b] = std::minmax({x[0][b_], x[1][b_], x[2][b_]});
    const auto [low_c, high_c] = std::minmax({x[0][c_], x[1][c_], x[2][c_]});
    for (int k = line_behind(c_, low_c); k < grid_.n[c_] && grid_.middle(static_cast<int>(c_), k) <= high_c; ++k) {
      for (int j = line_behind(b_, low_b); j < grid_.n[b_] && grid_.middle(static_cast<int>(b_), j) <= high_b; ++j)
        cross_triangle_by(s, nodes, x, j, k);
    }
  }

  void cross_triangle_by(std::size_t s, std::span<const int> nodes, const std::array<Vec<3>, 3>& x, int j, int k) {
    const double pb = grid_.middle(static_cast<int>(b_), j), pc = grid_.middle(static_cast<int>(c_), k);
    std::array<EdgeSide, 3> edge;  // opposite to each node
    for (std::size_t a = 0; a < 3; ++a) {
      const std::size_t i = (a + 1) % 3, l = (a + 2) % 3;
      edge[a] = side_of_edge(nodes[i], x[i], nodes[l], x[l], b_, c_, pb, pc);
    }
    if (edge[0].left != edge[1].left || edge[1].left != edge[2].left) return;
    const double twice = edge[0].twice_area + edge[1].twice_area + edge[2].twice_area;
    if (twice == 0) return;
    Vec<3> share;
    double place = 0;
    for (std::size_t a = 0; a < 3; ++a) share[a] = edge[a].twice_area / twice, place += share[a] * x[a][axis_];
    std::array<int, 3> at_line{};
    at_line[b_] = j, at_line[c_] = k;
    add(s, share, place, edge[0].left ? -1 : 1, at_line);  // left: the normal is along the axis
  }

  void add(std::size_t s, const Vec<3>& share, double place, int turn, std::array<int, 3> line) {
    const double box = (place - grid_.low[axis_]) / grid_.d[axis_];
    if (box > grid_.n[axis_] + 1) return;
    const int face = std::max(static_cast<int>(std::ceil(box - 0.5)), 0);
    if (face > grid_.n[axis_]) return;
    line[axis_] = face;
    const std::size_t f = grid_.face(static_cast<int>(axis_), line);
    turns_[f] += turn;
    if (surface_.cavity[at(surface_.sheet[s])] == 0) outer_turns_[f] += turn;
    if (box < 0 || box > grid_.n[axis_]) return;
    const int number = static_cast<int>(out_.all.size());
    out_.all.push_back({static_cast<int>(s), share, place});
    int &lowest = out_.lowest[axis_][f], &highest = out_.highest[axis_][f];
    if (lowest < 0 || place < out_.all[at(lowest)].place) lowest = number;
    if (highest < 0 || place > out_.all[at(highest)].place) highest = number;
  }

  const SolidSurface& surface_;
  std::span<const double> q_;
  const StaggeredGrid& grid_;
  std::size_t axis_, b_, c_;
  Crossings& out_;
  std::vector<int> outer_turns_;  // the same of outer sheets alone
  std::vector<int> turns_;        // into solids less out of them, at each face
};

}  // namespace

Crossings find_crossings(const SolidSurface& surface, std::span<const double> q, const StaggeredGrid& grid) {
  Crossings crossings;
  for (int axis = 0; axis < grid.dim; ++axis) {
    Sweep sweep(surface, q, grid, axis, crossings);
    sweep.run();
    if (axis == 0) sweep.mark_inside();
  }
  return crossings;
}

}  // namespace tether
