// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/numbers.hpp"
#include "physics/box/mesh/outline.hpp"
#include "physics/box/mesh/size_tree.hpp"

namespace tether::coupled {

/// Places with a size each, in square or cubic bins.
class PlacesInBins {
 public:
  PlacesInBins(int dim, const Vec<3>& low, const Vec<3>& high, double width);

  struct Place {
    Vec<3> x;
    double size;
  };
  void add(const Vec<3>& x, double size) { bins_[number(bin_at(x))].push_back({x, size}); }
  const std::array<int, 3>& count() const { return n_; }
  /// The bin that a place is in, or the nearest one.
  std::array<int, 3> bin_at(const Vec<3>& x) const;
  std::span<const Place> in(const std::array<int, 3>& bin) const { return bins_[number(bin)]; }
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
  std::size_t number(const std::array<int, 3>& bin) const {
    return at(bin[0]) + at(n_[0]) * (at(bin[1]) + at(n_[1]) * at(bin[2]));
  }

  Vec<3> low_;
  double width_;
  std::array<int, 3> n_{1, 1, 1};
  std::vector<std::vector<Place>> bins_;
};

double distance(const Vec<3>& a, const Vec<3>& b);

/// The size that a mesh is to have about an outline: that of the nearest facets, and more by the growth over the way.
class SizesAbout {
 public:
  static constexpr double apart = 0.6;  ///< of the size, from the outline on, is where a mesh has points

  double least;      ///< of the facets
  Vec<3> low, high;  ///< the outline's extent

  SizesAbout(const Outline& outline, const MeshSizes& sizes);

  /// Returns a size that none in a box about x is below, which is twice as wide as `half`.
  double least_in(const Vec<3>& x, const Vec<3>& half) const;
  /// Returns the size at a place; 0 where that is too near to the outline.
  double size_at(const Vec<3>& x) const;

 private:
  MeshSizes sizes_;
  SizeTree facets_;
};

}  // namespace tether::coupled
