// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "grid/crossings.hpp"
#include "grid/solid_surface.hpp"

namespace tether::liquid {

/// The place of the solids' surface that is nearest to another one.
struct NearestSurface {
  int side = -1;
  Vec<3> place{};       ///< [length]
  Vec<3> share{};       ///< of the side's nodes
  double distance = 0;  ///< [length]
};

/// Where the solids are, by the cells of a grid: each knows the sides that go through it or the cells next to it. All
/// arguments must outlive it.
class NearSolids {
 public:
  NearSolids(const SolidSurface& surface, std::span<const double> q, const StaggeredGrid& grid,
             const Crossings& crossings);

  /// Returns whether a place of the grid lies in a solid: the way there from its cell's middle, of which that is known,
  /// goes into one or out of one each time that it meets the surface. Safe to call by several threads.
  bool hold(const Vec<3>& x) const;
  /// The nearest place of the surface that no other solid holds, where any of it is about.
  std::optional<NearestSurface> nearest(const Vec<3>& x) const;
  /// Velocity of a place of the surface, u being that of its nodes; nodes beyond these rest.
  Vec<3> velocity(const NearestSurface& at, std::span<const double> u) const;
  bool none() const { return sides_.empty(); }

 private:
  NearestSurface nearest_of_side(int side, const Vec<3>& x) const;
  int turns(int side, const Vec<3>& from, const Vec<3>& to) const;
  bool is_buried(const NearestSurface& near) const;
  template <class Function>
  void each_cell_about(std::size_t side, const Function& f) const;

  const SolidSurface& surface_;
  std::span<const double> q_;
  const StaggeredGrid& grid_;
  const Crossings& crossings_;
  std::vector<std::size_t> first_;  // of each cell's sides
  std::vector<int> sides_;
};

}  // namespace tether::liquid
