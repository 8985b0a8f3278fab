// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/sizes_about.hpp"

#include <limits>

namespace tether::coupled {

PlacesInBins::PlacesInBins(int dim, const Vec<3>& low, const Vec<3>& high, double width) : low_(low), width_(width) {
  for (std::size_t a = 0; a < at(dim); ++a)
    n_[a] = std::max(1, static_cast<int>(std::ceil((high[a] - low[a]) / width)) + 1);
  bins_.resize(at(n_[0]) * at(n_[1]) * at(n_[2]));
}

void PlacesInBins::add(const Vec<3>& x, double size) {
  Bin& bin = bins_[number(bin_at(x))];
  bin.places.push_back({x, size});
  const double count = static_cast<double>(bin.places.size());
  bin.whole.size = count == 1 ? size : std::min(bin.whole.size, size);
  for (std::size_t a = 0; a < 3; ++a) bin.whole.x[a] += (x[a] - bin.whole.x[a]) / count;
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

SizesAbout::SizesAbout(const Outline& outline, const MeshSizes& sizes)
    : least(sizes.size), sizes_(sizes), away_(static_cast<int>(std::ceil(1 / sizes.growth))) {
  constexpr double far = std::numeric_limits<double>::max();
  low = {far, far, far}, high = {-far, -far, -far};
  for (const Vec<3>& x : outline.places) {
    for (std::size_t a = 0; a < 3; ++a) low[a] = std::min(low[a], x[a]), high[a] = std::max(high[a], x[a]);
  }
  along_.emplace(outline.dim, low, high, sizes.size);
  for (const Outline::Facet& facet : outline.facets) add(outline, facet);
}

/// Places on a facet, about a quarter of its edges apart.
void SizesAbout::add(const Outline& outline, const Outline::Facet& facet) {
  const Vec<3>&a = outline.places[facet.corners[0]], &b = outline.places[facet.corners[1]];
  const Vec<3> along = minus(b, a);
  double length = distance(a, b);
  Vec<3> across{};
  if (outline.dim == 3) {
    across = minus(outline.places[facet.corners[2]], a);
    const Vec<3> twice = cross(along, across);
    length = std::sqrt(2 / std::sqrt(3.0) * std::sqrt(dot(twice, twice)));  // of as large an equilateral triangle
  }
  if (length == 0) return;
  constexpr double shortest =
      1.0 / 32;  // of the size at bodies: what is shorter, as the edge of a thin body, has no cells as small
  const double size = std::clamp(length, shortest * sizes_.near, sizes_.size);
  least = std::min(least, size);
  const int parts = std::max(1, static_cast<int>(std::ceil((outline.dim == 3 ? 3 : 4) * length / size)));
  const int last = outline.dim == 3 ? parts : 1;
  for (int j = 0; j < last; ++j) {
    for (int i = 0; i + j < parts; ++i) {
      const double more = outline.dim == 3 ? 1.0 / 3 : 0.5, s = (i + more) / parts,
                   t = outline.dim == 3 ? (j + more) / parts : 0;
      along_->add({a[0] + s * along[0] + t * across[0], a[1] + s * along[1] + t * across[1],
                   a[2] + s * along[2] + t * across[2]},
                  size);
    }
  }
}

double SizesAbout::least_in(const std::array<int, 3>& bin) const {
  const double half = 0.5 * along_->width(), across = std::sqrt(3.0) * half;
  Vec<3> middle = low;
  for (std::size_t a = 0; a < 3; ++a) {
    if (along_->count()[a] > 1) middle[a] += (2 * bin[a] + 1) * half;
  }
  double size = sizes_.size;
  along_->each_bin_about(bin, away_ + 1, [&](const std::array<int, 3>& other) {
    const PlacesInBins::Place* whole = along_->whole(other);
    if (whole == nullptr) return;
    size = std::min(size, whole->size + sizes_.growth * std::max(0.0, distance(middle, whole->x) - 2 * across));
  });
  return size;
}

double SizesAbout::size_at(const Vec<3>& x) const {
  double size = sizes_.size, nearest = std::numeric_limits<double>::max();
  const std::array<int, 3> bin = along_->bin_at(x);
  along_->each_bin_about(bin, away_, [&](const std::array<int, 3>& other) {
    const auto meet = [&](const PlacesInBins::Place& place) {
      const double way = distance(x, place.x);
      size = std::min(size, place.size + sizes_.growth * way), nearest = std::min(nearest, way);
    };
    const bool near =
        std::abs(other[0] - bin[0]) <= 1 && std::abs(other[1] - bin[1]) <= 1 && std::abs(other[2] - bin[2]) <= 1;
    const PlacesInBins::Place* whole = along_->whole(other);
    if (whole == nullptr) return;
    if (!near) return meet(*whole);
    for (const PlacesInBins::Place& place : along_->in(other)) meet(place);
  });
  return nearest < apart * size ? 0 : size;
}

}  // namespace tether::coupled
