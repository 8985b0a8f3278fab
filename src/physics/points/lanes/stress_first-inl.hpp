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
HWY_NOINLINE void strain_and_stress(const LaneWork& work, std::ptrdiff_t n, Tile& tile, LaneFindings& found) {
  const LanePoints P = work.P;
  const LaneNodes N = work.N;
  if (Law::is_gas && N.heat) {
    locate<D, Kernel>(work, tile);
    gather_value<D, Kernel>(N.heat + n, work.grid.nx, tile, tile.at_place);
  }
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    const Locating<D, Kernel> locating(work.grid, tile, sub);
    const Straining<D, Kernel, Law::about_axis, false> strain(work.grid, {N.old_x + n, N.old_y + n}, sub);
    const Law law(work, n, sub);
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const std::size_t p = tile.slot[k] + sub;
      const V<D> x = load<D>(P.x + p);
      const Places<D> at = locating.inside(x, load<D>(P.y + p));
      store<D>(at.r, tile.r[k] + sub), store<D>(at.s, tile.s[k] + sub);
      const auto w = Kernel::template weights<D>(at);
      law.stress(tile, k, sub, w, strain.at(w, x, load<D>(P.mass + p)), found);
    }
  }
}

template <class D, class Kernel, class Law>
void strain_and_pull(const LaneWork& work, LaneFindings& found) {
  Forces<D, Kernel, Law::about_axis> forces(work);
  const auto each = [&](Tile& tile, std::ptrdiff_t n) HWY_ATTR {
    strain_and_stress<D, Kernel, Law>(work, n, tile, found);
    forces.put(tile, n);
  };
  sweep(work, each, [&]() HWY_ATTR { forces.close(); });
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
      const std::size_t p = tile.slot[k] + sub;
      const V<D> x = load<D>(P.x + p), mass = load<D>(P.mass + p);
      const Places<D> at = locating.inside(x, load<D>(P.y + p));
      heat_centred<D, axis>(P, p, dt, work.reads_stress, strain.at(Kernel::template weights<D>(at), x, mass));
    }
  }
}

/// Returns whether all points stay in their cells.
template <class D, class Kernel, bool affine>
HWY_NOINLINE bool accelerate_and_move(const LaneWork& work, std::ptrdiff_t n, Tile& tile, LaneFindings& found) {
  const LanePoints P = work.P;
  bool all_stay = true;
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    const Locating<D, Kernel> locating(work.grid, tile, sub);
    const Taking<D, Kernel, affine, true> taking(work, n, sub);
    Moving<D, Kernel, affine> moving(work, found, sub);
    V<D> squares = load<D>(found.squares + sub);
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const std::size_t p = tile.slot[k] + sub;
      const V<D> x = load<D>(P.x + p), y = load<D>(P.y + p), mass = load<D>(P.mass + p);
      const auto w = Kernel::template weights<D>(locating.inside(x, y));
      moving.move(locating, tile, k, sub, mass, x, y, taking.take(p, mass, w, squares));
    }
    store<D>(squares, found.squares + sub), store<D>(moving.lifted, found.lifted + sub);
    all_stay &= moving.all_stay;
  }
  return all_stay;
}

template <class D, class Kernel, bool affine, bool axis, bool books>
HWY_INLINE void accelerate_heat_and_move(const LaneWork& work, std::ptrdiff_t n, Tile& tile, LaneFindings& found) {
  const LaneNodes& N = work.N;
  const bool is_gas = work.body.law != LaneLaw::elastic;
  if (is_gas && !work.body.heats) heat<D, Kernel, axis>(work, n, tile);
  if constexpr (books) {
    locate<D, Kernel>(work, tile);
    gather_motion<D, Kernel>(N.old_x + n, N.old_y + n, work.grid.nx, tile);
    book_way_there<D>(work, tile);
    gather_value<D, Kernel>(N.squares + n, work.grid.nx, tile, tile.at_place);
  }
  const bool all_stay = accelerate_and_move<D, Kernel, affine>(work, n, tile, found);
  if constexpr (books) book_way_back<D>(work, tile, found);
  if (is_gas) note_waves<D>(work, tile, found);
  if (affine && work.records) record_motion<D>(work, tile);
  if (is_gas && work.records && !work.reads_stress) record_stress<D, axis>(work, tile);
  if (!all_stay) take_out<affine>(work, tile, found);
}

template <class D, class Kernel, bool affine, bool axis, bool books>
void accelerate_move_and_map(const LaneWork& work, LaneFindings& found) {
  Putting<D, Kernel, 5> momenta(work.grid.nx);
  set_rows(work.N, momenta);
  const auto each = [&](Tile& tile, std::ptrdiff_t n) HWY_ATTR {
    accelerate_heat_and_move<D, Kernel, affine, axis, books>(work, n, tile, found);
    momenta.begin(n);
    Kernel::template scatter_momenta<D, affine>(tile, momenta);
    if constexpr (books) {
      if (momenta.used > row_of_loss) Kernel::template scatter_value<D>(tile, tile.lost, momenta, row_of_loss);
    }
  };
  sweep(work, each, [&]() HWY_ATTR { momenta.close(); });
}

}  // namespace tether::mpm::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
