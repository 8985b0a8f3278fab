// SPDX-License-Identifier: GPL-3.0-or-later
// Read once for each instruction set, so without #pragma once.
#if defined(TETHER_POINTS_STRESS_FIRST_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TETHER_POINTS_STRESS_FIRST_INL
#undef TETHER_POINTS_STRESS_FIRST_INL
#else
#define TETHER_POINTS_STRESS_FIRST_INL
#endif

#include "physics/points/lanes/books-inl.hpp"
#include "physics/points/lanes/laws-inl.hpp"
#include "physics/points/lanes/move-inl.hpp"
#include "physics/points/lanes/straining-inl.hpp"
#include "physics/points/lanes/sweep-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tether::mpm::HWY_NAMESPACE {

// Updated stress first, first pass: strain rate (3.23), stress, force (3.16).

template <class D, class Kernel, class Law>
HWY_NOINLINE void strain_and_pull(const LaneWork& work, std::ptrdiff_t n, Tile& tile, ForceRows<D, Kernel>& forces,
                                  LaneFindings& found) {
  const LanePoints P = work.P;
  const LaneNodes N = work.N;
  const Law law(work);
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    const Locating<D, Kernel> locating(work.grid, tile, sub);
    const Straining<D, Kernel, Law::about_axis, false> strain(work.grid, {N.old_x + n, N.old_y + n}, sub);
    const FromNodes<D, Kernel, Law::by_nodes> density(Law::by_nodes ? N.rho + n : nullptr, work.grid.nx, sub);
    typename Kernel::template Forces<D> sums;
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const Layer<D> layer = layer_of<D>(P, locating, tile.slot[k] + sub);
      const auto w = Kernel::template weights<D>(layer.at);
      const V<D> warmth = Law::is_gas ? load<D>(tile.at_place[k] + sub) : hn::Zero(D());
      const Rates<D> rate = strain.at(w, layer.x, layer.mass);
      const Stressed<D> of = law.stress(P, layer.p, {density.at(w), warmth}, rate, found);
      forces.template add<Law::about_axis>(sums, tile, k, sub, layer.at, pull_of<D, Law::about_axis>(of, layer.x));
    }
    forces.put(sums, tile, sub);
  }
  if constexpr (Law::about_axis) forces.put_hoop(tile);
}

template <class D, class Kernel, class Law>
void strain_and_pull(const LaneWork& work, Blocks::Strip strip, LaneFindings& found) {
  ForceRows<D, Kernel> forces(work);
  const auto each = [&](Tile& tile, std::ptrdiff_t n) HWY_ATTR {
    if (Law::is_gas && work.N.heat) {
      locate<D, Kernel>(work, tile);
      gather_value<D, Kernel>(work.N.heat + n, work.grid.nx, tile, tile.at_place);
    }
    forces.begin(n);
    strain_and_pull<D, Kernel, Law>(work, n, tile, forces, found);
  };
  sweep(work, strip, each);
  forces.close();
}

// Second pass: velocities (3.22), heat of gas (4.10), places (3.21), mass and momentum (3.15).

template <class D, class Kernel, bool axis>
HWY_NOINLINE void heat(const LaneWork& work, std::ptrdiff_t n, Tile& tile) {
  const LanePoints P = work.P;
  const LaneNodes N = work.N;
  const V<D> dt = all<D>(work.dt);
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    const Locating<D, Kernel> locating(work.grid, tile, sub);
    const Straining<D, Kernel, axis, true> strain(work.grid, {N.old_x + n, N.old_y + n, N.new_x + n, N.new_y + n}, sub);
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const Layer<D> layer = layer_of<D>(P, locating, tile.slot[k] + sub);
      const Rates<D> rate = strain.at(Kernel::template weights<D>(layer.at), layer.x, layer.mass);
      heat_centred<D, axis>(P, layer.p, dt, work.reads_stress, rate);
    }
  }
}

template <class D, class Kernel, bool affine>
HWY_NOINLINE void accelerate_and_move(const LaneWork& work, std::ptrdiff_t n, Tile& tile,
                                      MomentumRows<D, Kernel>& momenta, LaneFindings& found) {
  const LanePoints P = work.P;
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    const Locating<D, Kernel> locating(work.grid, tile, sub);
    const Taking<D, Kernel, affine, true> taking(work, n, sub);
    Moving<D, Kernel> moving(work, found, sub);
    typename Kernel::template Momenta<D, affine> sums;
    V<D> squares = load<D>(found.squares + sub);
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const Layer<D> layer = layer_of<D>(P, locating, tile.slot[k] + sub);
      const auto w = Kernel::template weights<D>(layer.at);
      const Taken<D> taken = taking.take(P, layer.p, layer.mass, w, squares);
      const Arrived<D> here = moving.move(P, locating, tile, k, sub, layer, taken);
      sums.add(tile, k, sub, here.mass, here.at, taken.motion);
    }
    sums.put(P, tile, sub, momenta);
    store<D>(squares, found.squares + sub), store<D>(moving.lifted, found.lifted + sub);
  }
}

template <class D, class Kernel, bool affine, bool books>
HWY_INLINE void accelerate_heat_and_move(const LaneWork& work, std::ptrdiff_t n, Tile& tile,
                                         MomentumRows<D, Kernel>& momenta, LaneFindings& found) {
  const LaneNodes& N = work.N;
  const bool gas = is_gas(work.body.law);
  if (gas && !work.body.heats)
    work.about_axis ? heat<D, Kernel, true>(work, n, tile) : heat<D, Kernel, false>(work, n, tile);
  if constexpr (books) {
    locate<D, Kernel>(work, tile);
    gather_motion<D, Kernel>(N.old_x + n, N.old_y + n, work.grid.nx, tile);
    book_way_there<D>(work, tile);
    gather_value<D, Kernel>(N.squares + n, work.grid.nx, tile, tile.at_place);
  }
  accelerate_and_move<D, Kernel, affine>(work, n, tile, momenta, found);
  if constexpr (books) book_way_back<D>(work, tile, found);
  if (gas) note_waves<D, affine>(work, tile, found);
  if (affine && work.records) record_motion<D>(work, tile);
  if (gas && work.records && !work.reads_stress) record_stress<D>(work, tile);
  if (tile.some_left) take_out<affine, books>(work, tile, found);
}

template <class D, class Kernel, bool affine, bool books>
void accelerate_move_and_map(const LaneWork& work, Blocks::Strip strip, LaneFindings& found) {
  MomentumRows<D, Kernel> momenta(work.grid.nx);
  set_rows(work.N, momenta);
  const auto each = [&](Tile& tile, std::ptrdiff_t n) HWY_ATTR {
    momenta.begin(n);
    accelerate_heat_and_move<D, Kernel, affine, books>(work, n, tile, momenta, found);
    if constexpr (books) {
      if (momenta.used > row_of_loss) Kernel::template scatter_value<D>(tile, tile.lost, momenta, row_of_loss);
    }
  };
  sweep(work, strip, each);
  momenta.close();
}

}  // namespace tether::mpm::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
