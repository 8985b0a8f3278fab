// SPDX-License-Identifier: GPL-3.0-or-later
// Read once for each instruction set, so without #pragma once.
#if defined(TETHER_POINTS_STRESS_LAST_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TETHER_POINTS_STRESS_LAST_INL
#undef TETHER_POINTS_STRESS_LAST_INL
#else
#define TETHER_POINTS_STRESS_LAST_INL
#endif

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

template <class D, class Kernel, bool affine, bool last, class Law>
HWY_NOINLINE void strain_move_and_map(const LaneWork& work, std::ptrdiff_t n, Tile& tile,
                                      MomentumRows<D, Kernel>& momenta, ForceRows<D, Kernel, Law::about_axis>& forces,
                                      LaneFindings& found) {
  const LanePoints P = work.P;
  const Field field = straining_field<last>(work.N, n);
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    const Locating<D, Kernel> locating(work.grid, tile, sub);
    const Straining<D, Kernel, Law::about_axis, false> strain(work.grid, field, sub);
    const Taking<D, Kernel, affine, last> taking(work, n, sub);
    const Law law(work, n, sub);
    Moving<D, Kernel> moving(work, found, sub);
    typename Kernel::template Momenta<D, affine> mapped;
    typename Kernel::template Forces<D> pulled;
    V<D> squares = load<D>(found.squares + sub);
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const Layer<D> layer = layer_of<D>(P, locating, tile.slot[k] + sub);
      const auto w = Kernel::template weights<D>(layer.at);
      const Rates<D> rate = strain.at(w, layer.x, layer.mass);
      const Taken<D> taken = taking.take(P, layer.p, layer.mass, w, squares);
      const Arrived<D> here = moving.move(P, locating, tile, k, sub, layer, taken);
      Stressed<D> of = law.stress(P, layer.p, hn::Zero(D()), w, rate, found);
      of.volume = hn::IfThenElseZero(here.stay, of.volume);
      mapped.add(tile, k, sub, here.mass, here.at, taken.motion);
      forces.add(pulled, tile, k, sub, here.at, pull_of<D, Law::about_axis>(of, here.x));
    }
    mapped.put(P, tile, sub, momenta), forces.put(pulled, tile, sub);
    store<D>(squares, found.squares + sub), store<D>(moving.lifted, found.lifted + sub);
  }
  forces.put_hoop(tile);
}

template <class D, class Kernel, bool affine, bool last, class Law>
void strain_move_and_map(const LaneWork& work, Blocks::Strip strip, LaneFindings& found) {
  MomentumRows<D, Kernel> momenta(work.grid.nx);
  set_rows(work.N, momenta);
  ForceRows<D, Kernel, Law::about_axis> forces(work);
  const auto each = [&](Tile& tile, std::ptrdiff_t n) HWY_ATTR {
    momenta.begin(n), forces.begin(n);
    strain_move_and_map<D, Kernel, affine, last, Law>(work, n, tile, momenta, forces, found);
    if constexpr (Law::is_gas) note_waves<D, affine>(work, tile, found);
    if constexpr (Law::is_gas) record_stress<D, Law::about_axis>(work, tile);
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

template <class D, class Kernel, bool affine, bool axis, bool last>
void strain_and_move(const LaneWork& work, Blocks::Strip strip, LaneFindings& found) {
  const auto each = [&](Tile& tile, std::ptrdiff_t n) HWY_ATTR {
    strain_and_move<D, Kernel, affine, axis, last>(work, n, tile, found);
    if constexpr (affine && last) record_motion<D>(work, tile);
    if (tile.some_left) take_out<false>(work, tile, found);
  };
  sweep(work, strip, each);
}

template <class D, class Kernel, bool affine, class Law>
HWY_NOINLINE void stress_and_map(const LaneWork& work, std::ptrdiff_t n, Tile& tile, MomentumRows<D, Kernel>& momenta,
                                 ForceRows<D, Kernel, Law::about_axis>& forces, LaneFindings& found) {
  const LanePoints P = work.P;
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    const Locating<D, Kernel> locating(work.grid, tile, sub);
    const Law law(work, n, sub);
    typename Kernel::template Momenta<D, affine> mapped;
    typename Kernel::template Forces<D> pulled;
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const Layer<D> layer = layer_of<D>(P, locating, tile.slot[k] + sub);
      const auto w = Kernel::template weights<D>(layer.at);
      const Stressed<D> of = law.stress(P, layer.p, hn::Zero(D()), w, kept_rates<D>(P, layer.p), found);
      mapped.add(tile, k, sub, layer.mass, layer.at, motion_of<D, affine>(work, layer.p));
      forces.add(pulled, tile, k, sub, layer.at, pull_of<D, Law::about_axis>(of, layer.x));
    }
    mapped.put(P, tile, sub, momenta), forces.put(pulled, tile, sub);
  }
  forces.put_hoop(tile);
}

template <class D, class Kernel, bool affine, class Law>
void stress_and_map(const LaneWork& work, Blocks::Strip strip, LaneFindings& found) {
  MomentumRows<D, Kernel> momenta(work.grid.nx);
  set_rows(work.N, momenta);
  ForceRows<D, Kernel, Law::about_axis> forces(work);
  const auto each = [&](Tile& tile, std::ptrdiff_t n) HWY_ATTR {
    momenta.begin(n), forces.begin(n);
    stress_and_map<D, Kernel, affine, Law>(work, n, tile, momenta, forces, found);
    note_waves<D, affine>(work, tile, found), record_stress<D, Law::about_axis>(work, tile);
  };
  sweep(work, strip, each);
  momenta.close();
  forces.close();
}

}  // namespace tether::mpm::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
