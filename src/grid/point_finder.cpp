// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/point_finder.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "grid/shapes.hpp"

namespace tether {
namespace {

constexpr double outside = 1e-9;  // by which a place may be outside, of an element's size
constexpr double farthest = 4;    // in the reference element: where a search has lost its way

double length(const Vec<2>& d) { return std::sqrt(d[0] * d[0] + d[1] * d[1]); }
double largest(const Vec<2>& s) { return std::max(std::abs(s[0]), std::abs(s[1])); }
Vec<2> clamped(const Vec<2>& s) { return {std::clamp(s[0], -1.0, 1.0), std::clamp(s[1], -1.0, 1.0)}; }

const double* node(const Mesh& mesh, std::size_t e, std::size_t a) {
  return &mesh.x[2 * static_cast<std::size_t>(mesh.element(e)[a])];
}

/// Returns what separates x from the place that s stands for; node by node, as differences within an element lose
/// nothing to its distance from the origin.
template <class Shapes>
Vec<2> remainder(const Mesh& mesh, std::size_t e, const Vec<2>& x, const Vec<2>& s) {
  const auto N = Shapes::values(s);
  Vec<2> r{};
  for (std::size_t a = 0; a < N.size(); ++a) {
    const double* at = node(mesh, e, a);
    r[0] += N[a] * (x[0] - at[0]), r[1] += N[a] * (x[1] - at[1]);
  }
  return r;
}

/// dx_i / ds_j, row-major.
template <class Shapes>
std::array<double, 4> slopes(const Mesh& mesh, std::size_t e, const Vec<2>& s) {
  const auto G = Shapes::gradients(s);
  std::array<double, 4> J{};
  for (std::size_t a = 0; a < G.size() / 2; ++a) {
    const double* at = node(mesh, e, a);
    for (std::size_t i = 0; i < 2; ++i) J[2 * i] += at[i] * G[2 * a], J[2 * i + 1] += at[i] * G[2 * a + 1];
  }
  return J;
}

double determinant(const std::array<double, 4>& J) { return J[0] * J[3] - J[1] * J[2]; }

std::array<double, 4> inverse(const std::array<double, 4>& J) {
  const double det = determinant(J);
  return {J[3] / det, -J[1] / det, -J[2] / det, J[0] / det};
}

Vec<2> times(const std::array<double, 4>& m, const Vec<2>& v) {
  return {m[0] * v[0] + m[1] * v[1], m[2] * v[0] + m[3] * v[1]};
}

/// s of x by Newton's method from s, each step halved until it comes nearer, until `enough` or nothing is left.
/// Returns how far from x the place of s still is.
template <class Shapes>
double search(const Mesh& mesh, std::size_t e, const Vec<2>& x, double enough, Vec<2>& s) {
  Vec<2> r = remainder<Shapes>(mesh, e, x, s);
  for (int step = 0; step < 40 && length(r) > enough; ++step) {
    const Vec<2> full = times(inverse(slopes<Shapes>(mesh, e, s)), r);
    bool nearer = false;
    double part = 1;
    for (int halved = 0; halved < 10 && !nearer; ++halved, part /= 2) {
      const Vec<2> next{s[0] + part * full[0], s[1] + part * full[1]};
      const Vec<2> rest = remainder<Shapes>(mesh, e, x, next);
      nearer = length(rest) < length(r);
      if (nearer) s = next, r = rest;
    }
    if (!nearer || !(largest(s) < farthest)) break;
  }
  return length(r);
}

/// Lowest and highest coordinate i of an element. Control points instead of middle nodes: an edge may bulge out beyond
/// its three nodes, never beyond the control points of the same curve.
std::array<double, 2> range(const Mesh& mesh, std::size_t e, std::size_t i) {
  const auto line = static_cast<std::size_t>(order_of(mesh.kind)) + 1;
  std::array<double, 9> x{};
  for (std::size_t a = 0; a < line * line; ++a) x[a] = node(mesh, e, a)[i];
  if (line == 3) {
    for (std::size_t k = 0; k < 9; k += 3) x[k + 1] = 2 * x[k + 1] - 0.5 * (x[k] + x[k + 2]);
    for (std::size_t k = 0; k < 3; ++k) x[k + 3] = 2 * x[k + 3] - 0.5 * (x[k] + x[k + 6]);
  }
  const auto ends = std::minmax_element(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(line * line));
  return {*ends.first, *ends.second};
}

/// A lower bound of the length in space of a unit of s, from the map's slopes at the corners.
template <class Shapes>
double least_stretch(const Mesh& mesh, std::size_t e) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec<2>& corner : {Vec<2>{-1, -1}, Vec<2>{1, -1}, Vec<2>{-1, 1}, Vec<2>{1, 1}}) {
    const auto J = slopes<Shapes>(mesh, e, corner);
    const double norm = std::sqrt(J[0] * J[0] + J[1] * J[1] + J[2] * J[2] + J[3] * J[3]);
    least = std::min(least, std::abs(determinant(J)) / norm);
  }
  return least;
}

}  // namespace

PointFinder::PointFinder(const Mesh& mesh) : mesh_(&mesh) {
  assert(mesh.kind == ElementKind::quad4 || mesh.kind == ElementKind::quad9);
  for (const double x : mesh.x) rounding_ = std::max(rounding_, std::abs(x));
  rounding_ *= 64 * std::numeric_limits<double>::epsilon();
  for (std::size_t e = 0; e < mesh.element_count(); ++e) outlines_.push_back(outline_of(e));
  if (!outlines_.empty()) fill_bins();
}

PointFinder::Outline PointFinder::outline_of(std::size_t e) const {
  Outline o;
  const auto x = range(*mesh_, e, 0), y = range(*mesh_, e, 1);
  const double size = length({x[1] - x[0], y[1] - y[0]});
  o.within = std::max(outside * size, rounding_), o.enough = 16 * std::numeric_limits<double>::epsilon() * size;
  o.low = {x[0] - o.within, y[0] - o.within}, o.high = {x[1] + o.within, y[1] + o.within};
  // Shapes of order 1 between the corners have the mean slopes at the middle, whatever the element's own order.
  const auto last = static_cast<std::size_t>(node_count_of(mesh_->kind)) - 1;
  const auto line = static_cast<std::size_t>(order_of(mesh_->kind));
  const double *a = node(*mesh_, e, 0), *b = node(*mesh_, e, line), *c = node(*mesh_, e, last - line),
               *d = node(*mesh_, e, last);
  std::array<double, 4> J{};
  for (std::size_t i = 0; i < 2; ++i) {
    o.centre[i] = 0.25 * (a[i] + b[i] + c[i] + d[i]);
    J[2 * i] = 0.25 * (b[i] + d[i] - a[i] - c[i]), J[2 * i + 1] = 0.25 * (c[i] + d[i] - a[i] - b[i]);
  }
  o.to_reference = inverse(J), o.affine = true;
  for (std::size_t k = 0; k <= last; ++k) {
    const double unit = 2.0 / static_cast<double>(line);
    const std::size_t i = k % (line + 1), j = k / (line + 1);
    const Vec<2> s{unit * static_cast<double>(i) - 1, unit * static_cast<double>(j) - 1};
    const Vec<2> at = times(J, s);
    const double* to = node(*mesh_, e, k);
    o.affine = o.affine && length({o.centre[0] + at[0] - to[0], o.centre[1] + at[1] - to[1]}) <= 0.25 * rounding_;
  }
  const double stretch = mesh_->kind == ElementKind::quad4 ? least_stretch<ShapesOf<ElementKind::quad4>>(*mesh_, e)
                                                           : least_stretch<ShapesOf<ElementKind::quad9>>(*mesh_, e);
  o.interior = 1 - 8 * rounding_ / stretch;
  return o;
}

/// About as many bins as elements, in the proportions of the mesh.
void PointFinder::fill_bins() {
  Vec<2> high = outlines_[0].high;
  low_ = outlines_[0].low;
  for (const Outline& o : outlines_) {
    for (std::size_t i = 0; i < 2; ++i) low_[i] = std::min(low_[i], o.low[i]), high[i] = std::max(high[i], o.high[i]);
  }
  const Vec<2> size{high[0] - low_[0], high[1] - low_[1]};
  const double width = std::sqrt(size[0] * size[1] / static_cast<double>(outlines_.size()));
  for (std::size_t i = 0; i < 2; ++i) {
    const double most = static_cast<double>(outlines_.size());
    count_[i] = static_cast<std::size_t>(std::clamp(std::ceil(size[i] / width), 1.0, most));
    per_width_[i] = static_cast<double>(count_[i]) / size[i];
  }
  start_.assign(count_[0] * count_[1] + 1, 0);
  const auto each_bin = [&](const Outline& o, const auto& f) {
    for (std::size_t j = bin(o.low[1], 1); j <= bin(o.high[1], 1); ++j) {
      for (std::size_t i = bin(o.low[0], 0); i <= bin(o.high[0], 0); ++i) f(j * count_[0] + i);
    }
  };
  for (const Outline& o : outlines_) each_bin(o, [&](std::size_t b) { ++start_[b + 1]; });
  for (std::size_t b = 1; b < start_.size(); ++b) start_[b] += start_[b - 1];
  list_.resize(static_cast<std::size_t>(start_.back()));
  std::vector<int> next(start_.begin(), start_.end() - 1);
  for (std::size_t e = 0; e < outlines_.size(); ++e)
    each_bin(outlines_[e], [&](std::size_t b) { list_[static_cast<std::size_t>(next[b]++)] = static_cast<int>(e); });
}

/// Returns the bin of the coordinate along an axis; it is monotone, so that a box has all bins between those of its
/// ends.
std::size_t PointFinder::bin(double x, std::size_t axis) const {
  const double most = static_cast<double>(count_[axis] - 1);
  return static_cast<std::size_t>(std::clamp((x - low_[axis]) * per_width_[axis], 0.0, most));
}

/// s of x in element e or outside of it, from the guess that its corners give; nothing where x is far away.
template <class Shapes>
std::optional<Vec<2>> PointFinder::reference_place(std::size_t e, const Vec<2>& x) const {
  const Outline& o = outlines_[e];
  Vec<2> s = times(o.to_reference, {x[0] - o.centre[0], x[1] - o.centre[1]});
  if (o.affine) return s;
  s = clamped(s);
  if (search<Shapes>(*mesh_, e, x, o.enough, s) <= rounding_) return s;
  return std::nullopt;
}

/// Does the same for elements much bent, in which a search may go astray, and come to an s outside that stands for the
/// same place: it tries nine starts until one leads inside.
template <class Shapes>
std::optional<Vec<2>> PointFinder::reference_place_bent(std::size_t e, const Vec<2>& x) const {
  constexpr std::array<double, 3> starts{0, -0.8, 0.8};
  for (std::size_t k = 0; k < 9 && !outlines_[e].affine; ++k) {
    Vec<2> s{starts[k % 3], starts[k / 3]};
    const double left = search<Shapes>(*mesh_, e, x, outlines_[e].enough, s);
    if (left <= rounding_ && largest(s) <= 1) return s;
  }
  return std::nullopt;
}

/// The element of lowest number near x for which `place` gives a place inside, or the nearest within its tolerance.
template <class Shapes, class ReferencePlace>
std::optional<PointFinder::Found> PointFinder::find_near(const Vec<2>& x, const ReferencePlace& place) const {
  Found nearest;
  double least = std::numeric_limits<double>::infinity();
  const std::size_t b = bin(x[1], 1) * count_[0] + bin(x[0], 0);
  for (auto k = static_cast<std::size_t>(start_[b]); k < static_cast<std::size_t>(start_[b + 1]); ++k) {
    const auto e = static_cast<std::size_t>(list_[k]);
    if (!outlines_[e].may_hold(x)) continue;
    const std::optional<Vec<2>> s = place(e);
    if (!s) continue;
    const Vec<2> in = clamped(*s);
    const double outside = in == *s ? 0 : length(remainder<Shapes>(*mesh_, e, x, in));
    if (outside <= rounding_) return Found{list_[k], in};
    if (outside <= outlines_[e].within && outside < least) nearest = {list_[k], in}, least = outside;
  }
  if (nearest.element < 0) return std::nullopt;
  return nearest;
}

template <class Shapes>
std::optional<PointFinder::Found> PointFinder::find_of(const Vec<2>& x, int hint) const {
  if (hint >= 0 && static_cast<std::size_t>(hint) < outlines_.size()) {
    const auto e = static_cast<std::size_t>(hint);
    const auto s = outlines_[e].may_hold(x) ? reference_place<Shapes>(e, x) : std::nullopt;
    if (s && largest(*s) < outlines_[e].interior) return Found{hint, *s};
  }
  const auto found = find_near<Shapes>(x, [&](std::size_t e) { return reference_place<Shapes>(e, x); });
  return found ? found : find_near<Shapes>(x, [&](std::size_t e) { return reference_place_bent<Shapes>(e, x); });
}

std::optional<PointFinder::Found> PointFinder::find(Vec<2> x, int hint) const {
  if (outlines_.empty() || !std::isfinite(x[0]) || !std::isfinite(x[1])) return std::nullopt;
  return mesh_->kind == ElementKind::quad4 ? find_of<ShapesOf<ElementKind::quad4>>(x, hint)
                                           : find_of<ShapesOf<ElementKind::quad9>>(x, hint);
}

}  // namespace tether
