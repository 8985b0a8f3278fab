// SPDX-License-Identifier: GPL-3.0-or-later
// Read once for each instruction set, so without #pragma once.
#if defined(TETHER_POINTS_TILE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TETHER_POINTS_TILE_INL
#undef TETHER_POINTS_TILE_INL
#else
#define TETHER_POINTS_TILE_INL
#endif

#include "loops/lanes-inl.hpp"
#include "physics/points/lanes/work.hpp"

HWY_BEFORE_NAMESPACE();
namespace tether::mpm::HWY_NAMESPACE {

using namespace tether::HWY_NAMESPACE;

// A pass takes the points of a group of cells, up to so many layers of eight at a time, through its stages. What a
// stage leaves for the next one stands in a tile, which never leaves the nearest cache.

constexpr std::size_t lanes = Blocks::lanes;
constexpr std::size_t most_layers = 12;

using TileRows = double[most_layers][lanes];

struct alignas(64) Tile {
  TileRows r, s;                                // place in the cell, from -0.5 to 0.5 about a spline's node [cells]
  TileRows xx, xy, yx, yy;                      // grad v, d v_x / d y in xy [1/time]
  TileRows rho, heat;                           // of gas, at its place
  TileRows xx_by_x, xy_by_x, xy_by_y, yy_by_y;  // -V sigma over twice a cell's side [force]
  TileRows m;                                   // mass; 0 where there is no point, or none that stays
  TileRows vx, vy;                              // velocity
  TileRows middle_x, middle_y;                  // and that at the cell's middle
  TileRows gxx, gyx, gxy, gyy;                  // the field about the point, a difference from node to node [velocity]
  TileRows lost;                                // kinetic energy per mass that the transfers lose [velocity^2]
  std::size_t slot[most_layers];                // of lane 0
  std::size_t layers;
  double x0, y0;  // lane 0's cell along x, the group's along y
};

/// Nine sums of a group's cells, one for each node around: node 3 l + k stands at (k - 1, l - 1).
using NineSums = double[9][lanes];

/// What the two lanes before a vector of each sum were.
template <class D>
using NineBefore = Before<D>[9];

/// Adds the sums of a group whose first cell is `cell` to the nodes around: a node takes what the cell behind it, its
/// own and the one before it give, in this order, and the rows from below.
template <class D>
HWY_INLINE void put_nine(const NineSums& sums, NineBefore<D>& before, double* row, std::ptrdiff_t nx) {
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    for (std::ptrdiff_t l = 0; l < 3; ++l) {
      const V<D> behind = load<D>(sums[3 * l] + sub), own = load<D>(sums[3 * l + 1] + sub),
                 ahead = load<D>(sums[3 * l + 2] + sub);
      const V<D> all_three = (behind + up_by_one<D>(own, before[3 * l + 1])) + up_by_two<D>(ahead, before[3 * l + 2]);
      add_to<D>(row + (l - 1) * nx - 1 + static_cast<std::ptrdiff_t>(sub), all_three);
      before[3 * l + 1].follow(own), before[3 * l + 2].follow(ahead);
    }
  }
}

/// What is left of the last two cells of a run of groups that ends before `row`'s node.
template <class D>
HWY_INLINE void put_rest_of_nine(NineBefore<D>& before, double* row, std::ptrdiff_t nx) {
  const V<D> none = hn::Zero(D());
  for (std::ptrdiff_t sub = 0; sub < (width<D> == 1 ? 2 : 1); ++sub) {
    for (std::ptrdiff_t l = 0; l < 3; ++l) {
      const V<D> two = (none + up_by_one<D>(none, before[3 * l + 1])) + up_by_two<D>(none, before[3 * l + 2]);
      add_to<D>(row + (l - 1) * nx - 1 + sub, two);
      before[3 * l + 1].follow(none), before[3 * l + 2].follow(none);
    }
  }
}

/// Adds sums of groups, one after the other, to some rows of the nodes.
template <class D, std::size_t count>
struct Putting {
  double* rows[count];
  std::ptrdiff_t nx;
  std::size_t used = count;  // of the rows
  NineBefore<D> before[count] = {};
  std::ptrdiff_t end = -1;  // node after the last group

  /// A group whose first cell's node is n.
  HWY_INLINE void begin(std::ptrdiff_t n) {
    if (end >= 0 && end != n) rest();
    end = n + static_cast<std::ptrdiff_t>(lanes);
  }
  HWY_INLINE void put(std::size_t q, const NineSums& sums) {
    put_nine<D>(sums, before[q], rows[q] + end - static_cast<std::ptrdiff_t>(lanes), nx);
  }
  HWY_INLINE void rest() {
    for (std::size_t q = 0; q < used; ++q) put_rest_of_nine<D>(before[q], rows[q] + end, nx);
  }
  HWY_INLINE void close() {
    if (end >= 0) rest();
    end = -1;
  }
};

/// Takes the next layers of a chain of blocks; false where there are none any more.
inline bool next_layers(const Blocks& blocks, std::uint32_t& block, Tile& tile) {
  tile.layers = 0;
  for (; block != Blocks::none && tile.layers < most_layers; block = blocks.next(block)) {
    tile.slot[tile.layers++] = block * lanes;
  }
  return tile.layers > 0;
}

}  // namespace tether::mpm::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
