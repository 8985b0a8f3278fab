// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/size_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/numbers.hpp"
#include "physics/box/mesh/facet_distance.hpp"

namespace tether::coupled {

namespace {

Box<3> extent_of(const SizeTree::Facet& facet, int dim) {
  Box<3> of{facet.corners[0], facet.corners[0]};
  for (std::size_t k = 1; k < at(dim); ++k) {
    for (std::size_t a = 0; a < 3; ++a) {
      of.low[a] = std::min(of.low[a], facet.corners[k][a]);
      of.high[a] = std::max(of.high[a], facet.corners[k][a]);
    }
  }
  return of;
}

}  // namespace

struct SizeTree::Search {
  Vec<3> x, half;  // the box that is looked from
  double growth, apart;
  Nearby found;

  double to(const Vec<3>& low, const Vec<3>& high) const {
    double square = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      const double way = std::max({0.0, low[a] - x[a] - half[a], x[a] - half[a] - high[a]});
      square += way * way;
    }
    return std::sqrt(square);
  }
  bool is_place() const { return half == Vec<3>{}; }
  bool may_matter(double least, double way) const {
    return least + growth * way < found.size || way < std::min(found.nearest, apart * found.size);
  }
};

SizeTree::SizeTree(int dim, std::vector<Facet> facets) : dim_(dim), facets_(std::move(facets)) {
  if (facets_.empty()) return;
  parts_.push_back({{}, {}, 0, 0, facets_.size()});
  for (std::size_t part = 0; part < parts_.size(); ++part) halve(part);
}

void SizeTree::halve(std::size_t part) {
  constexpr std::size_t few = 4;
  constexpr double far = std::numeric_limits<double>::max();
  Part of = parts_[part];
  of.low = {far, far, far}, of.high = {-far, -far, -far}, of.least = far;
  for (std::size_t k = of.first; k < of.last; ++k) {
    const Box<3> extent = extent_of(facets_[k], dim_);
    of.least = std::min(of.least, facets_[k].size);
    for (std::size_t a = 0; a < 3; ++a)
      of.low[a] = std::min(of.low[a], extent.low[a]), of.high[a] = std::max(of.high[a], extent.high[a]);
  }
  const std::size_t middle = (of.first + of.last) / 2;
  if (of.last - of.first > few) {
    const Vec<3> wide = minus(of.high, of.low);
    const auto axis = static_cast<std::size_t>(std::max_element(wide.begin(), wide.end()) - wide.begin());
    const auto facet = [&](std::size_t k) { return facets_.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(facet(of.first), facet(middle), facet(of.last), [&](const Facet& a, const Facet& b) {
      return a.corners[0][axis] + a.corners[1][axis] < b.corners[0][axis] + b.corners[1][axis];
    });
    of.below = static_cast<int>(parts_.size());
    parts_.push_back({{}, {}, 0, of.first, middle}), parts_.push_back({{}, {}, 0, middle, of.last});
  }
  parts_[part] = of;
}

SizeTree::Nearby SizeTree::about(const Vec<3>& x, double growth, double size, double apart) const {
  Search search{x, {}, growth, apart, {size, std::numeric_limits<double>::max()}};
  if (!parts_.empty()) look(0, search);
  return search.found;
}

double SizeTree::least_in(const Vec<3>& x, const Vec<3>& half, double growth, double size) const {
  Search search{x, half, growth, 0, {size, std::numeric_limits<double>::max()}};
  if (!parts_.empty()) look(0, search);
  return search.found.size;
}

void SizeTree::look(std::size_t part, Search& search) const {
  const Part& of = parts_[part];
  if (of.below < 0) {
    for (std::size_t k = of.first; k < of.last; ++k) {
      const Box<3> extent = extent_of(facets_[k], dim_);
      double way = search.to(extent.low, extent.high);
      if (!search.may_matter(facets_[k].size, way)) continue;
      if (search.is_place()) way = facet_distance(dim_, facets_[k].corners, search.x);
      search.found.size = std::min(search.found.size, facets_[k].size + search.growth * way);
      search.found.nearest = std::min(search.found.nearest, way);
    }
    return;
  }
  std::array<std::pair<double, std::size_t>, 2> halves;  // the nearer first
  for (std::size_t k = 0; k < 2; ++k) {
    const std::size_t half = at(of.below) + k;
    halves[k] = {search.to(parts_[half].low, parts_[half].high), half};
  }
  std::ranges::sort(halves);
  for (const auto& [way, half] : halves) {
    if (search.may_matter(parts_[half].least, way)) look(half, search);
  }
}

}  // namespace tether::coupled
