// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/sizes_about.hpp"

#include <limits>
#include <utility>

namespace tether::coupled {

PlacesInBins::PlacesInBins(int dim, const Vec<3>& low, const Vec<3>& high, double width) : low_(low), width_(width) {
  for (std::size_t a = 0; a < at(dim); ++a)
    n_[a] = std::max(1, static_cast<int>(std::ceil((high[a] - low[a]) / width)) + 1);
  bins_.resize(at(n_[0]) * at(n_[1]) * at(n_[2]));
}

std::array<int, 3> PlacesInBins::bin_at(const Vec<3>& x) const {
  std::array<int, 3> bin{};
  for (std::size_t a = 0; a < 3; ++a)
    bin[a] = n_[a] == 1 ? 0 : std::clamp(static_cast<int>((x[a] - low_[a]) / width_), 0, n_[a] - 1);
  return bin;
}

double distance(const Vec<3>& a, const Vec<3>& b) {
  const Vec<3> way = minus(a, b);
  return std::sqrt(dot(way, way));
}

namespace {

/// With the sizes that the mesh is to have at them.
std::vector<SizeTree::Facet> sized_facets(const Outline& outline, const MeshSizes& sizes) {
  constexpr double shortest =
      1.0 / 32;  // of the size at bodies: what is shorter, as the edge of a thin body, has no cells as small
  std::vector<SizeTree::Facet> facets;
  for (const Outline::Facet& of : outline.facets) {
    SizeTree::Facet facet{};
    for (std::size_t k = 0; k < at(outline.dim); ++k) facet.corners[k] = outline.places[of.corners[k]];
    facet.size = of.size > 0 ? of.size : outline.size_of(of);
    if (facet.size == 0) continue;
    facet.size = std::clamp(facet.size, shortest * sizes.near, sizes.size);
    facets.push_back(facet);
  }
  return facets;
}

}  // namespace

SizesAbout::SizesAbout(const Outline& outline, const MeshSizes& sizes)
    : least(sizes.size), sizes_(sizes), facets_(outline.dim, sized_facets(outline, sizes)) {
  constexpr double far = std::numeric_limits<double>::max();
  low = {far, far, far}, high = {-far, -far, -far};
  for (const Vec<3>& x : outline.places) {
    for (std::size_t a = 0; a < 3; ++a) low[a] = std::min(low[a], x[a]), high[a] = std::max(high[a], x[a]);
  }
  least = std::min(least, facets_.least());
}

double SizesAbout::least_in(const Vec<3>& x, const Vec<3>& half) const {
  return facets_.least_in(x, half, sizes_.growth, sizes_.size);
}

double SizesAbout::size_at(const Vec<3>& x) const {
  const auto [size, nearest] = facets_.about(x, sizes_.growth, sizes_.size, apart);
  return nearest < apart * size ? 0 : size;
}

}  // namespace tether::coupled
