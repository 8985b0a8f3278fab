// SPDX-License-Identifier: GPL-3.0-or-later
// Read once for each instruction set, so without #pragma once.
#if defined(TETHER_POINTS_SWEEP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TETHER_POINTS_SWEEP_INL
#undef TETHER_POINTS_SWEEP_INL
#else
#define TETHER_POINTS_SWEEP_INL
#endif

#include "physics/points/lanes/tile-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tether::mpm::HWY_NAMESPACE {

// What all passes do: a sweep over the groups of a strip, and sums for the nodes' rows.

/// Calls each(tile, n) for the points of the strip's groups, n the node of a group's first cell.
template <class Each>
HWY_INLINE void sweep(const LaneWork& work, Blocks::Strip strip, const Each& each) {
  const Blocks& blocks = *work.blocks;
  Tile tile;
  for (std::size_t g = strip.begin; g < strip.end; ++g) {
    const Blocks::Group& group = blocks.groups()[g];
    tile.x0 = group.cell, tile.y0 = group.row;
    for (std::uint32_t block = group.first; next_layers(blocks, block, tile);)
      each(tile, group.row * work.grid.nx + group.cell);
  }
}

/// Rows of internal forces (3.16), about an axis with the hoop's.
template <class D, class Kernel>
class ForceRows {
 public:
  using Sums = typename Kernel::template Forces<D>;

  HWY_INLINE explicit ForceRows(const LaneWork& work) : grid_(work.grid), rows_(work.grid.nx) {
    rows_.rows[0] = work.N.force_x, rows_.rows[1] = work.N.force_y, rows_.rows[2] = work.N.force_x;
    rows_.used = work.about_axis ? 3 : 2;
  }
  HWY_INLINE void begin(std::ptrdiff_t n) { rows_.begin(n); }
  template <bool axis>
  HWY_INLINE void add(Sums& sums, Tile& tile, std::size_t k, std::size_t sub, Places<D> at, const Pull<D>& of) const {
    sums.add(tile, k, sub, at, of);
    if constexpr (axis) {
      store<D>(at.r, tile.r[k] + sub), store<D>(at.s, tile.s[k] + sub);
      store<D>(of.hoop, tile.hoop[k] + sub);
    }
  }
  HWY_INLINE void put(const Sums& sums, const Tile& tile, std::size_t sub) { sums.put(tile, grid_, sub, rows_); }
  /// After all of a tile.
  HWY_INLINE void put_hoop(const Tile& tile) {
    if (rows_.used > 2) Kernel::template scatter_value<D>(tile, tile.hoop, rows_, 2);
  }
  /// Adds what stands in a tile.
  HWY_NOINLINE void pull(Tile& tile) {
    for (std::size_t sub = 0; sub < lanes; sub += width<D>) put(Sums::of(tile, sub), tile, sub);
    put_hoop(tile);
  }
  HWY_INLINE void close() { rows_.close(); }

 private:
  LaneGrid grid_;
  Putting<D, Kernel, 3> rows_;
};

/// Rows of mass and momentum, of the gas's mass and of what the ledger books, as far as the scene has them.
template <class D, class Kernel>
using MomentumRows = Putting<D, Kernel, 5>;
template <class D, class Kernel>
HWY_INLINE void set_rows(const LaneNodes& N, MomentumRows<D, Kernel>& momenta) {
  momenta.rows[row_of_m] = N.m, momenta.rows[row_of_x] = N.momentum_x, momenta.rows[row_of_y] = N.momentum_y;
  momenta.rows[row_of_gas] = N.gas, momenta.rows[row_of_loss] = N.loss;
  momenta.used = N.loss ? 5 : N.gas ? 4 : 3;
}

}  // namespace tether::mpm::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
