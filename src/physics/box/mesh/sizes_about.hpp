// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "base/numbers.hpp"
#include "physics/box/mesh/outline.hpp"

namespace tether::coupled {

/// Places with a size each, in square or cubic bins.
class PlacesInBins {
 public:
  PlacesInBins(int dim, const Vec<3>& low, const Vec<3>& high, double width);

  struct Place {
    Vec<3> x;
    double size;
  };
  void add(const Vec<3>& x, double size);
  const std::array<int, 3>& count() const { return n_; }
  double width() const { return width_; }
  /// The bin that a place is in, or the nearest one.
  std::array<int, 3> bin_at(const Vec<3>& x) const;
  std::span<const Place> in(const std::array<int, 3>& bin) const { return bins_[number(bin)].places; }
  /// One place for all of a bin: their mean, with their least size. Null where it has none.
  const Place* whole(const std::array<int, 3>& bin) const {
    const Bin& of = bins_[number(bin)];
    return of.places.empty() ? nullptr : &of.whole;
  }
  /// Calls f(bin) for the bins up to so many away from one.
  template <class Function>
  void each_bin_about(const std::array<int, 3>& bin, int away, const Function& f) const {
    const auto from = [&](std::size_t a) { return std::max(0, bin[a] - away); };
    const auto to = [&](std::size_t a) { return std::min(n_[a] - 1, bin[a] + away); };
    for (int k = from(2); k <= to(2); ++k) {
      for (int j = from(1); j <= to(1); ++j) {
        for (int i = from(0); i <= to(0); ++i) f(std::array{i, j, k});
      }
    }
  }
  /// Calls f(place) for those in the bins within a reach of a place.
  template <class Function>
  void each_within(const Vec<3>& x, double reach, const Function& f) const {
    each_bin_about(bin_at(x), static_cast<int>(std::ceil(reach / width_)), [&](const std::array<int, 3>& bin) {
      for (const Place& place : in(bin)) f(place);
    });
  }

 private:
  struct Bin {
    std::vector<Place> places;
    Place whole{};
  };
  std::size_t number(const std::array<int, 3>& bin) const {
    return at(bin[0]) + at(n_[0]) * (at(bin[1]) + at(n_[1]) * at(bin[2]));
  }

  Vec<3> low_;
  double width_;
  std::array<int, 3> n_{1, 1, 1};
  std::vector<Bin> bins_;
};

double distance(const Vec<3>& a, const Vec<3>& b);

/// The size that a mesh is to have about an outline: that of the nearest facets, and more by the growth over the way;
/// facets that are far count as one for each bin of the mesh's largest size.
class SizesAbout {
 public:
  static constexpr double apart = 0.6;  ///< of the size, from the outline on, is where a mesh has points

  double least;      ///< of the facets
  Vec<3> low, high;  ///< the outline's extent

  SizesAbout(const Outline& outline, const MeshSizes& sizes);

  const PlacesInBins& bins() const { return *along_; }
  /// Returns a size that none in a bin is below.
  double least_in(const std::array<int, 3>& bin) const;
  /// Returns the size at a place; 0 where that is too near to the outline.
  double size_at(const Vec<3>& x) const;

 private:
  void add(const Outline& outline, const Outline::Facet& facet);

  MeshSizes sizes_;
  int away_;                           // bins, of those that may matter
  std::optional<PlacesInBins> along_;  // places on the facets, with the lengths of their edges
};

}  // namespace tether::coupled
