// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/overlaps.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers.hpp"

namespace tether {
namespace {

constexpr double touching = 1e-6;  // of a body's size

/// Appends the edges or triangles of a side.
void add_facets(const Mesh& mesh, const int* side, std::vector<int>& facets) {
  for (const auto& facet : facets_of_side(mesh.kind)) {
    for (int a = 0; a < mesh.dim(); ++a) facets.push_back(side[facet[at(a)]]);
  }
}

/// Twice the area that the edge from a to b and x span in the plane of y and z, with the sign of the turn; where that
/// is zero, of x a little farther along y or, failing that, along z. The other way round it is the same with another
/// sign, to the last bit.
double turn(const Vec<3>& a, const Vec<3>& b, const Vec<3>& x, bool swapped) {
  if (swapped) return -turn(b, a, x, false);
  const double y = b[1] - a[1], z = b[2] - a[2];
  const double twice = y * (x[2] - a[2]) - z * (x[1] - a[1]);
  return twice != 0 ? twice : z != 0 ? -z : y;
}

/// +1 where a line from x along the first axis leaves the body through an edge, -1 where it enters, 0 where it passes.
int crossing(const Vec<3>& a, const Vec<3>& b, const Vec<3>& x, bool swapped) {
  const bool up = a[1] <= x[1] && x[1] < b[1], down = b[1] <= x[1] && x[1] < a[1];
  if (!up && !down) return 0;
  const Vec<3>&from = swapped ? b : a, &to = swapped ? a : b;
  double left = (to[0] - from[0]) * (x[1] - from[1]) - (to[1] - from[1]) * (x[0] - from[0]);
  if (swapped) left = -left;
  return up && left > 0 ? 1 : down && left < 0 ? -1 : 0;
}

/// Does the same through a triangle.
int crossing(std::span<const int> nodes, const std::array<Vec<3>, 3>& corners, const Vec<3>& x) {
  std::array<double, 3> turns{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    turns[k] = turn(corners[k], corners[next], x, nodes[k] > nodes[next]);
  }
  const bool leaves = turns[0] > 0 && turns[1] > 0 && turns[2] > 0;
  const bool enters = turns[0] < 0 && turns[1] < 0 && turns[2] < 0;
  if (!leaves && !enters) return 0;
  const double before = dot(cross(minus(corners[1], corners[0]), minus(corners[2], corners[0])), minus(x, corners[0]));
  return leaves && before < 0 ? 1 : enters && before > 0 ? -1 : 0;
}

double size_of(const Vec<3>& a) { return std::sqrt(dot(a, a)); }

/// From the origin to the edge from a to b.
double distance_to(const Vec<3>& a, const Vec<3>& b) {
  const Vec<3> way = minus(b, a);
  const double square = dot(way, way), part = square > 0 ? std::clamp(-dot(a, way) / square, 0.0, 1.0) : 0;
  return size_of({a[0] + part * way[0], a[1] + part * way[1], a[2] + part * way[2]});
}

/// From the origin to a triangle: to its plane where the foot lies in it, to an edge else. The same for an edge, b = c.
double distance_to(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c) {
  const Vec<3> normal = cross(minus(b, a), minus(c, a));
  const bool within = dot(normal, cross(a, b)) > 0 && dot(normal, cross(b, c)) > 0 && dot(normal, cross(c, a)) > 0;
  if (within) return std::abs(dot(normal, a)) / size_of(normal);
  return std::min({distance_to(a, b), distance_to(b, c), distance_to(c, a)});
}

}  // namespace

OverlapFinder::OverlapFinder(const Mesh& mesh) : dim_(mesh.dim()), parts_(at(count_parts(mesh))) {
  const std::vector<int> part = parts_of(mesh);
  for (std::size_t n = 0; n < part.size(); ++n) {
    if (part[n] >= 0) parts_[at(part[n])].nodes.push_back(static_cast<int>(n));
  }
  const Sides sides = boundary_of(mesh);
  const auto per_side = at(side_node_count_of(mesh.kind));
  for (std::size_t s = 0; s < sides.size(); s += per_side) {
    Part& owner = parts_[at(part[at(sides[s])])];
    add_facets(mesh, &sides[s], owner.facets);
    owner.rim.insert(owner.rim.end(), sides.begin() + static_cast<std::ptrdiff_t>(s),
                     sides.begin() + static_cast<std::ptrdiff_t>(s + per_side));
  }
  find_boxes(mesh.x);
  for (Part& p : parts_) {
    std::sort(p.rim.begin(), p.rim.end());
    p.rim.erase(std::unique(p.rim.begin(), p.rim.end()), p.rim.end());
    const Vec<3> size = minus(p.high, p.low);
    rounding_.push_back(touching * std::sqrt(dot(size, size)));
  }
}

void OverlapFinder::find_boxes(std::span<const double> q) {
  for (Part& part : parts_) {
    part.low = part.high = place(q, part.nodes.front());
    for (const int node : part.nodes) {
      const Vec<3> x = place(q, node);
      for (std::size_t i = 0; i < 3; ++i) {
        part.low[i] = std::min(part.low[i], x[i]), part.high[i] = std::max(part.high[i], x[i]);
      }
    }
  }
}

/// About as many columns as facets; a facet stands in all that its box reaches into.
void OverlapFinder::sort_facets(const Part& part, std::span<const double> q) {
  const std::size_t d = at(dim_), facets = part.facets.size() / d;
  const double a_line = dim_ == 2 ? static_cast<double>(facets) : std::sqrt(static_cast<double>(facets));
  columns_.low = part.low;
  for (std::size_t i = 1; i < d; ++i) {
    const double length = part.high[i] - part.low[i];
    columns_.n[i] = static_cast<int>(a_line) + 1;
    columns_.per_length[i] = length > 0 ? columns_.n[i] / length : 0;
  }
  const auto column = [&](double x, std::size_t i) {
    return std::clamp(static_cast<int>((x - columns_.low[i]) * columns_.per_length[i]), 0, columns_.n[i] - 1);
  };
  const auto for_columns = [&](std::size_t f, const auto& use) {
    std::array<int, 3> first{}, last{};
    for (std::size_t i = 1; i < d; ++i) {
      double low = INFINITY, high = -INFINITY;
      for (std::size_t a = 0; a < d; ++a) {
        const double x = q[at(part.facets[f * d + a]) * d + i];
        low = std::min(low, x), high = std::max(high, x);
      }
      first[i] = column(low, i), last[i] = column(high, i);
    }
    for (int z = first[2]; z <= last[2]; ++z) {
      for (int y = first[1]; y <= last[1]; ++y) use(at(y + columns_.n[1] * z));
    }
  };
  columns_.start.assign(at(columns_.n[1] * columns_.n[2]) + 1, 0);
  for (std::size_t f = 0; f < facets; ++f) for_columns(f, [&](std::size_t c) { ++columns_.start[c + 1]; });
  for (std::size_t c = 1; c < columns_.start.size(); ++c) columns_.start[c] += columns_.start[c - 1];
  columns_.facet.resize(columns_.start.back());
  std::vector<std::size_t> end = columns_.start;
  for (std::size_t f = 0; f < facets; ++f) for_columns(f, [&](std::size_t c) { columns_.facet[end[c]++] = f; });
}

/// Calls f(facet's nodes) for the facets in the column of x.
template <class Function>
void OverlapFinder::for_column(const Part& part, const Vec<3>& x, const Function& f) const {
  const std::size_t d = at(dim_);
  std::array<int, 3> c{};
  for (std::size_t i = 1; i < d; ++i)
    c[i] = std::clamp(static_cast<int>((x[i] - columns_.low[i]) * columns_.per_length[i]), 0, columns_.n[i] - 1);
  const std::size_t column = at(c[1] + columns_.n[1] * c[2]);
  for (std::size_t k = columns_.start[column]; k < columns_.start[column + 1]; ++k)
    f(std::span(part.facets).subspan(columns_.facet[k] * d, d));
}

/// How often the body's surface goes round x: its exits less its entries on a line from there.
int OverlapFinder::turns(const Part& part, std::span<const double> q, const Vec<3>& x) const {
  for (std::size_t i = 0; i < at(dim_); ++i) {
    if (x[i] < part.low[i] || x[i] > part.high[i]) return 0;
  }
  int sum = 0;
  for_column(part, x, [&](std::span<const int> nodes) {
    if (dim_ == 2)
      sum += crossing(place(q, nodes[0]), place(q, nodes[1]), x, nodes[0] > nodes[1]);
    else
      sum += crossing(nodes, {place(q, nodes[0]), place(q, nodes[1]), place(q, nodes[2])}, x);
  });
  return sum;
}

/// Returns whether x is as near to a body's surface as counts as touching: what is so near reaches into a column about
/// it.
bool OverlapFinder::touches(const Part& part, std::span<const double> q, const Vec<3>& x, double near) const {
  bool touches = false;
  const auto look = [&](std::span<const int> nodes) {
    const Vec<3> a = minus(place(q, nodes[0]), x), b = minus(place(q, nodes[1]), x),
                 c = dim_ == 2 ? b : minus(place(q, nodes[2]), x);
    touches = touches || distance_to(a, b, c) < near;
  };
  for (const double y : {-near, near}) {
    for (const double z : {-near, near}) {
      if (dim_ == 3 || z > 0) for_column(part, {x[0], x[1] + y, x[2] + (dim_ == 3 ? z : 0)}, look);
    }
  }
  return touches;
}

/// Returns whether a node of another body at x lies in the body and does not touch it; or one of its own surface: then
/// places a little away from it all lie in the body, and some twice. The ways there are along no axis, so that they do
/// not lead along surfaces.
bool OverlapFinder::is_deep_in(const Part& part, std::span<const double> q, const Vec<3>& x, bool its_own) const {
  constexpr std::array<Vec<3>, 2> in_plane{{{0.8253, 0.5647, 0}, {-0.5647, 0.8253, 0}}};
  constexpr std::array<Vec<3>, 3> in_space{
      {{0.7431, 0.5563, 0.3719}, {-0.5563, 0.7983, -0.2307}, {-0.3719, -0.2307, 0.8991}}};
  const double away = rounding_[static_cast<std::size_t>(&part - parts_.data())];
  if (!its_own) return turns(part, q, x) > 0 && !touches(part, q, x, away);
  const std::span<const Vec<3>> ways =
      dim_ == 2 ? std::span<const Vec<3>>(in_plane) : std::span<const Vec<3>>(in_space);
  int most = 0;
  for (const Vec<3>& way : ways) {
    for (const double by : {away, -away}) {
      const int about = turns(part, q, {x[0] + by * way[0], x[1] + by * way[1], x[2] + by * way[2]});
      if (about < 1) return false;
      most = std::max(most, about);
    }
  }
  return most > 1;
}

Overlap OverlapFinder::find(std::span<const double> q) {
  Overlap found;
  find_boxes(q);
  const auto meet = [&](const Part& a, const Part& b, double by) {
    for (std::size_t i = 0; i < at(dim_); ++i) {
      if (a.high[i] < b.low[i] + by || b.high[i] < a.low[i] + by) return false;
    }
    return true;
  };
  for (std::size_t b = 0; b < parts_.size(); ++b) {
    sort_facets(parts_[b], q);
    for (std::size_t a = 0; a < parts_.size(); ++a) {
      if (a != b && !meet(parts_[a], parts_[b], rounding_[b])) continue;
      for (const int node : a == b ? parts_[a].rim : parts_[a].nodes) {
        const Vec<3> x = place(q, node);
        if (!is_deep_in(parts_[b], q, x, a == b)) continue;
        if (found.nodes++ == 0) found = {1, node, static_cast<int>(a), static_cast<int>(b), x};
      }
    }
  }
  return found;
}

std::optional<Vec<3>> OverlapFinder::find_held(std::span<const Vec<3>> places, std::span<const double> q) {
  find_boxes(q);
  for (const Part& part : parts_) {
    sort_facets(part, q);
    const auto held = std::ranges::find_if(places, [&](const Vec<3>& x) { return is_deep_in(part, q, x, false); });
    if (held != places.end()) return *held;
  }
  return std::nullopt;
}

double OverlapFinder::depth(const Overlap& overlap, std::span<const double> q) const {
  const std::span<const int> facets = parts_[at(overlap.other)].facets;
  const std::size_t d = at(dim_);
  double least = INFINITY;
  for (std::size_t f = 0; f < facets.size(); f += d) {
    const Vec<3> a = minus(place(q, facets[f]), overlap.place), b = minus(place(q, facets[f + 1]), overlap.place);
    least = std::min(least,
                     dim_ == 2 ? distance_to(a, b) : distance_to(a, b, minus(place(q, facets[f + 2]), overlap.place)));
  }
  return least;
}

}  // namespace tether
