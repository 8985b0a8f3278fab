// SPDX-License-Identifier: GPL-3.0-or-later
// Read once for each instruction set, so without #pragma once.
#if defined(TETHER_POINTS_STRESS_LAST_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TETHER_POINTS_STRESS_LAST_INL
#undef TETHER_POINTS_STRESS_LAST_INL
#else
#define TETHER_POINTS_STRESS_LAST_INL
#endif

#include <bit>

#include "physics/points/lanes/laws-inl.hpp"
#include "physics/points/lanes/move-inl.hpp"
#include "physics/points/lanes/straining-inl.hpp"
#include "physics/points/lanes/sweep-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tether::mpm::HWY_NAMESPACE {

// Velocities mapped back first: velocities (3.22), and their momenta on the nodes again (3.24).

template <class D, class Kernel, bool affine>
HWY_NOINLINE void accelerate(const LaneWork& work, std::ptrdiff_t n, Tile& tile, Putting<D, Kernel, 2>& momenta,
                             LaneFindings& found) {
  const LanePoints P = work.P;
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    const Locating<D, Kernel> locating(work.grid, tile, sub);
    const Taking<D, Kernel, affine, true> taking(work, n, sub);
    typename Kernel::template Momenta<D, affine> sums;
    V<D> squares = load<D>(found.squares + sub);
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const Layer<D> layer = layer_of<D>(P, locating, tile.slot[k] + sub);
      const auto w = Kernel::template weights<D>(layer.at);
      const Taken<D> taken = taking.take(P, layer.p, layer.mass, w, squares);
      sums.add(tile, k, sub, layer.mass, layer.at, taken.motion);
    }
    sums.put(P, tile, sub, momenta);
    store<D>(squares, found.squares + sub);
  }
  if (affine) record_motion<D>(work, tile);
}

template <class D, class Kernel, bool affine>
void accelerate_and_convect(const LaneWork& work, Blocks::Strip strip, LaneFindings& found) {
  Putting<D, Kernel, 2> momenta(work.grid.nx);
  momenta.rows[row_of_x] = work.N.convected_x, momenta.rows[row_of_y] = work.N.convected_y;
  const auto each = [&](Tile& tile, std::ptrdiff_t n) HWY_ATTR {
    momenta.begin(n);
    accelerate<D, Kernel, affine>(work, n, tile, momenta, found);
  };
  sweep(work, strip, each);
  momenta.close();
}

// Strain rate at the old place (3.23), new place (3.21), stress, and the map to the new place's nodes (3.15), (3.16).
// Where velocities were not mapped back (`last`), they are taken here, too (3.22).

/// The velocities that strain.
template <bool last>
HWY_INLINE Field straining_field(const LaneNodes& N, std::ptrdiff_t n) {
  return last ? Field{N.new_x + n, N.new_y + n} : Field{N.old_x + n, N.old_y + n};
}

/// Hooke's law follows the rates at once and leaves in the tile what pulls; other laws find the rates there. So no law
/// is compiled for every kernel but the one that the thesis' solids have, whose numbers are read while others are
/// computed.
template <class D, class Kernel, bool affine, bool axis, bool last>
HWY_NOINLINE void strain_move_and_map(const LaneWork& work, std::ptrdiff_t n, Tile& tile,
                                      MomentumRows<D, Kernel>& momenta, LaneFindings& found) {
  const LanePoints P = work.P;
  const Field field = straining_field<last>(work.N, n);
  const bool elastic = work.body.law == LaneLaw::elastic, turns = work.body.law == LaneLaw::one_by_one;
  const Elastic<D, axis> law(work);
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    const Locating<D, Kernel> locating(work.grid, tile, sub);
    const Straining<D, Kernel, axis, false> strain(work.grid, field, sub);
    const Taking<D, Kernel, affine, last> taking(work, n, sub);
    Moving<D, Kernel> moving(work, found, sub);
    typename Kernel::template Momenta<D, affine> mapped;
    V<D> squares = load<D>(found.squares + sub);
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const Layer<D> layer = layer_of<D>(P, locating, tile.slot[k] + sub);
      const auto w = Kernel::template weights<D>(layer.at);
      const Rates<D> rate = strain.at(w, layer.x, layer.mass);
      const Taken<D> taken = taking.take(P, layer.p, layer.mass, w, squares);
      const Arrived<D> here = moving.move(P, locating, tile, k, sub, layer, taken);
      mapped.add(tile, k, sub, here.mass, here.at, taken.motion);
      if (elastic) {
        Stressed<D> of = law.stress(P, layer.p, not_from_nodes<D>(), rate, found);
        of.volume = hn::IfThenElseZero(here.stay, of.volume);
        store_pull<D, axis>(pull_of<D, axis>(of, here.x), tile, k, sub);
      } else {
        store_rates<D, axis>(rate, turns, tile, k, sub);
      }
    }
    mapped.put(P, tile, sub, momenta);
    store<D>(squares, found.squares + sub), store<D>(moving.lifted, found.lifted + sub);
  }
}

/// Points that have left their cells pull at none of the nodes around these.
inline void let_go(Tile& tile) {
  for (std::size_t k = 0; k < tile.layers; ++k) {
    for (unsigned left = tile.left[k]; left != 0; left &= left - 1) {
      const auto l = static_cast<std::size_t>(std::countr_zero(left));
      tile.pull_xx[k][l] = tile.pull_xy[k][l] = tile.pull_yy[k][l] = tile.hoop[k][l] = 0;
    }
  }
}

/// Stresses by the rates in the tile, and what pulls at the nodes around the points' new places: of those that have
/// left their cells nothing, they pull when they are settled.
template <class D, class Law>
HWY_NOINLINE void stress(const LaneWork& work, Tile& tile, LaneFindings& found) {
  const LanePoints P = work.P;
  const Law law(work);
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const std::size_t p = tile.slot[k] + sub;
      const Stressed<D> of = law.stress(P, p, not_from_nodes<D>(), rates_of<D, Law::about_axis>(tile, k, sub), found);
      store_pull<D, Law::about_axis>(pull_of<D, Law::about_axis>(of, load<D>(P.x + p)), tile, k, sub);
    }
  }
  if (tile.some_left) let_go(tile);
}
template <class D, bool axis>
HWY_INLINE void stress(const LaneWork& work, Tile& tile, LaneFindings& found) {
  if (work.body.law == LaneLaw::one_by_one) return stress<D, OneByOne<D, axis>>(work, tile, found);
  stress<D, Gas<D, axis, LaneLaw::gas_of_continuity>>(work, tile, found);
}
template <class D>
HWY_INLINE void stress(const LaneWork& work, Tile& tile, LaneFindings& found) {
  work.about_axis ? stress<D, true>(work, tile, found) : stress<D, false>(work, tile, found);
}

template <class D, class Kernel, bool affine, bool last>
void strain_move_and_map(const LaneWork& work, Blocks::Strip strip, LaneFindings& found) {
  MomentumRows<D, Kernel> momenta(work.grid.nx);
  set_rows(work.N, momenta);
  ForceRows<D, Kernel> forces(work);
  const auto each = [&](Tile& tile, std::ptrdiff_t n) HWY_ATTR {
    momenta.begin(n), forces.begin(n);
    work.about_axis ? strain_move_and_map<D, Kernel, affine, true, last>(work, n, tile, momenta, found)
                    : strain_move_and_map<D, Kernel, affine, false, last>(work, n, tile, momenta, found);
    if (work.body.law != LaneLaw::elastic) stress<D>(work, tile, found);
    forces.pull(tile);
    if (is_gas(work.body.law)) note_waves<D, affine>(work, tile, found), record_stress<D>(work, tile);
    if constexpr (affine && last) record_motion<D>(work, tile);
    if (tile.some_left) take_out<false>(work, tile, found);
  };
  sweep(work, strip, each);
  momenta.close();
  forces.close();
}

// The same where a law waits for its neighbours' new places: the strain rates stand in the points' arrays meanwhile.

template <class D>
HWY_INLINE void keep_rates(const LanePoints& P, std::size_t p, const Rates<D>& rate) {
  store<D>(rate.xx, P.dxx + p), store<D>(rate.yy, P.dyy + p), store<D>(all<D>(0.5) * rate.xy, P.dxy + p);
  store<D>(rate.zz, P.dzz + p);
}
template <class D>
HWY_INLINE Rates<D> kept_rates(const LanePoints& P, std::size_t p) {
  return {load<D>(P.dxx + p), load<D>(P.dyy + p), all<D>(2) * load<D>(P.dxy + p), load<D>(P.dzz + p), hn::Zero(D())};
}

template <class D, class Kernel, bool affine, bool axis, bool last>
HWY_NOINLINE void strain_and_move(const LaneWork& work, std::ptrdiff_t n, Tile& tile, LaneFindings& found) {
  const LanePoints P = work.P;
  const Field field = straining_field<last>(work.N, n);
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    const Locating<D, Kernel> locating(work.grid, tile, sub);
    const Straining<D, Kernel, axis, false> strain(work.grid, field, sub);
    const Taking<D, Kernel, affine, last> taking(work, n, sub);
    Moving<D, Kernel> moving(work, found, sub);
    V<D> squares = load<D>(found.squares + sub);
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const Layer<D> layer = layer_of<D>(P, locating, tile.slot[k] + sub);
      const auto w = Kernel::template weights<D>(layer.at);
      keep_rates<D>(P, layer.p, strain.at(w, layer.x, layer.mass));
      const Taken<D> taken = taking.take(P, layer.p, layer.mass, w, squares);
      moving.move(P, locating, tile, k, sub, layer, taken);
      if constexpr (affine) store_motion<D>(taken.motion, tile, k, sub);
    }
    store<D>(squares, found.squares + sub), store<D>(moving.lifted, found.lifted + sub);
  }
}

template <class D, class Kernel, bool affine, bool last>
void strain_and_move(const LaneWork& work, Blocks::Strip strip, LaneFindings& found) {
  const auto each = [&](Tile& tile, std::ptrdiff_t n) HWY_ATTR {
    work.about_axis ? strain_and_move<D, Kernel, affine, true, last>(work, n, tile, found)
                    : strain_and_move<D, Kernel, affine, false, last>(work, n, tile, found);
    if constexpr (affine && last) record_motion<D>(work, tile);
    if (tile.some_left) take_out<false>(work, tile, found);
  };
  sweep(work, strip, each);
}

/// Density of gas that finds it at the nodes (4.5).
template <class D, class Kernel>
HWY_NOINLINE void take_density(const LaneWork& work, std::ptrdiff_t n, const Tile& tile) {
  const LanePoints P = work.P;
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    const Locating<D, Kernel> locating(work.grid, tile, sub);
    const typename Kernel::template Value<D> density(work.N.rho + n, work.grid.nx, sub);
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const Layer<D> layer = layer_of<D>(P, locating, tile.slot[k] + sub);
      store<D>(density.at(Kernel::template weights<D>(layer.at)), P.rho + layer.p);
    }
  }
}

/// Stresses of gas that has waited, mass and momentum (3.15) and forces (3.16).
template <class D, class Kernel, bool affine, bool axis>
HWY_NOINLINE void stress_and_map(const LaneWork& work, Tile& tile, MomentumRows<D, Kernel>& momenta,
                                 ForceRows<D, Kernel>& forces, LaneFindings& found) {
  const LanePoints P = work.P;
  const Gas<D, axis, LaneLaw::gas_of_cells> law(work);
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    const Locating<D, Kernel> locating(work.grid, tile, sub);
    typename Kernel::template Momenta<D, affine> mapped;
    typename Kernel::template Forces<D> pulled;
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const Layer<D> layer = layer_of<D>(P, locating, tile.slot[k] + sub);
      const Stressed<D> of = law.stress(P, layer.p, not_from_nodes<D>(), kept_rates<D>(P, layer.p), found);
      mapped.add(tile, k, sub, layer.mass, layer.at, motion_of<D, affine>(work, layer.p));
      forces.template add<axis>(pulled, tile, k, sub, layer.at, pull_of<D, axis>(of, layer.x));
    }
    mapped.put(P, tile, sub, momenta), forces.put(pulled, tile, sub);
  }
  if constexpr (axis) forces.put_hoop(tile);
}

template <class D, class Kernel, bool affine>
void stress_and_map(const LaneWork& work, Blocks::Strip strip, LaneFindings& found) {
  MomentumRows<D, Kernel> momenta(work.grid.nx);
  set_rows(work.N, momenta);
  ForceRows<D, Kernel> forces(work);
  const auto each = [&](Tile& tile, std::ptrdiff_t n) HWY_ATTR {
    momenta.begin(n), forces.begin(n);
    if (work.body.law == LaneLaw::gas_of_nodes) take_density<D, Kernel>(work, n, tile);
    work.about_axis ? stress_and_map<D, Kernel, affine, true>(work, tile, momenta, forces, found)
                    : stress_and_map<D, Kernel, affine, false>(work, tile, momenta, forces, found);
    note_waves<D, affine>(work, tile, found), record_stress<D>(work, tile);
  };
  sweep(work, strip, each);
  momenta.close();
  forces.close();
}

}  // namespace tether::mpm::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
