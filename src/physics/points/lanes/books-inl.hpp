// SPDX-License-Identifier: GPL-3.0-or-later
// Read once for each instruction set, so without #pragma once.
#if defined(TETHER_POINTS_LANE_BOOKS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TETHER_POINTS_LANE_BOOKS_INL
#undef TETHER_POINTS_LANE_BOOKS_INL
#else
#define TETHER_POINTS_LANE_BOOKS_INL
#endif

#include "physics/points/lanes/tile-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tether::mpm::HWY_NAMESPACE {

// What the balance of energy and the ledger want of points that run by lanes; passes.hpp has the same one by one.

/// The point's own field, in differences from node to node.
template <class D>
HWY_INLINE void own_field(const LaneWork& work, std::size_t p, V<D> own[6]) {
  const V<D> dx = all<D>(1 / work.grid.per_dx), dy = all<D>(1 / work.grid.per_dy);
  own[0] = load<D>(work.P.vx + p), own[1] = load<D>(work.P.vy + p);
  own[2] = dx * load<D>(work.P.vxx + p), own[3] = dx * load<D>(work.P.vyx + p);
  own[4] = dy * load<D>(work.P.vxy + p), own[5] = dy * load<D>(work.P.vyy + p);
}
template <class D>
HWY_INLINE void field_of_tile(const Tile& tile, std::size_t k, std::size_t sub, V<D> field[6]) {
  field[0] = load<D>(tile.vx[k] + sub), field[1] = load<D>(tile.vy[k] + sub);
  field[2] = load<D>(tile.gxx[k] + sub), field[3] = load<D>(tile.gyx[k] + sub);
  field[4] = load<D>(tile.gxy[k] + sub), field[5] = load<D>(tile.gyy[k] + sub);
}
/// v . v' + C : C' D of two fields: sum_i N_i of their values' products at the nodes [velocity^2].
template <class D>
HWY_INLINE V<D> product(const V<D> a[6], const V<D> b[6]) {
  return (a[0] * b[0] + a[1] * b[1]) + all<D>(0.25) * ((a[2] * b[2] + a[3] * b[3]) + (a[4] * b[4] + a[5] * b[5]));
}

/// Books what the way to the nodes costs: |given|^2 - 2 given . old, with the field of the old velocities in the tile.
template <class D>
HWY_INLINE void book_way_there(const LaneWork& work, Tile& tile) {
  for (std::size_t k = 0; k < tile.layers; ++k) {
    for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
      V<D> given[6], old[6];
      own_field<D>(work, tile.slot[k] + sub, given), field_of_tile<D>(tile, k, sub, old);
      store<D>(product<D>(given, given) - all<D>(2) * product<D>(given, old), tile.lost[k] + sub);
    }
  }
}
/// And the way back: the nodes' squares, which stand in tile.at_place, less |taken|^2.
template <class D>
HWY_INLINE void book_way_back(const LaneWork& work, Tile& tile, LaneFindings& found) {
  for (std::size_t k = 0; k < tile.layers; ++k) {
    for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
      V<D> taken[6];
      field_of_tile<D>(tile, k, sub, taken);
      const V<D> lost = (load<D>(tile.lost[k] + sub) - product<D>(taken, taken)) + load<D>(tile.at_place[k] + sub);
      const V<D> energy = all<D>(0.5) * (load<D>(work.P.mass + tile.slot[k] + sub) * lost);
      store<D>(energy, tile.lost[k] + sub);
      add_to<D>(found.heat + sub, energy);
    }
  }
}

}  // namespace tether::mpm::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
