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
HWY_NOINLINE void accelerate(const LaneWork& work, std::ptrdiff_t n, Tile& tile, LaneFindings& found) {
  const LanePoints P = work.P;
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    const Locating<D, Kernel> locating(work.grid, tile, sub);
    const Taking<D, Kernel, affine, true> taking(work, n, sub);
    V<D> squares = load<D>(found.squares + sub);
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const std::size_t p = tile.slot[k] + sub;
      const V<D> mass = load<D>(P.mass + p);
      const Places<D> at = locating.inside(load<D>(P.x + p), load<D>(P.y + p));
      const Taken<D> taken = taking.take(p, mass, Kernel::template weights<D>(at), squares);
      leave_momenta<D, Kernel, affine>(tile, k, sub, mass, mass > hn::Zero(D()), at, taken.motion);
    }
    store<D>(squares, found.squares + sub);
  }
  if (affine) record_motion<D>(work, tile);
}

template <class D, class Kernel, bool affine>
void accelerate_and_convect(const LaneWork& work, LaneFindings& found) {
  Putting<D, Kernel, 2> momenta(work.grid.nx);
  momenta.rows[row_of_x] = work.N.convected_x, momenta.rows[row_of_y] = work.N.convected_y;
  const auto each = [&](Tile& tile, std::ptrdiff_t n) HWY_ATTR {
    accelerate<D, Kernel, affine>(work, n, tile, found);
    momenta.begin(n);
    Kernel::template scatter_momenta<D, affine>(tile, momenta);
  };
  sweep(work, each, [&]() HWY_ATTR { momenta.close(); });
}

// Strain rate at the old place (3.23), new place (3.21), stress, and the map to the new place's nodes (3.15), (3.16).
// Where velocities were not mapped back (`last`), they are taken here, too (3.22).

/// Returns whether all points stay in their cells.
template <class D, class Kernel, bool affine, bool last, class Law>
HWY_NOINLINE bool strain_move_and_stress(const LaneWork& work, std::ptrdiff_t n, Tile& tile, LaneFindings& found) {
  const LanePoints P = work.P;
  const LaneNodes N = work.N;
  const Field field = last ? Field{N.new_x + n, N.new_y + n} : Field{N.old_x + n, N.old_y + n};
  bool all_stay = true;
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    const Locating<D, Kernel> locating(work.grid, tile, sub);
    const Straining<D, Kernel, Law::about_axis, false> strain(work.grid, field, sub);
    const Taking<D, Kernel, affine, last> taking(work, n, sub);
    const Law law(work, n, sub);
    Moving<D, Kernel, affine> moving(work, found, sub);
    V<D> squares = load<D>(found.squares + sub);
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const std::size_t p = tile.slot[k] + sub;
      const V<D> x = load<D>(P.x + p), y = load<D>(P.y + p), mass = load<D>(P.mass + p);
      const auto w = Kernel::template weights<D>(locating.inside(x, y));
      const Rates<D> rate = strain.at(w, x, mass);
      moving.move(locating, tile, k, sub, mass, x, y, taking.take(p, mass, w, squares));
      law.stress(tile, k, sub, w, rate, found);
    }
    store<D>(squares, found.squares + sub), store<D>(moving.lifted, found.lifted + sub);
    all_stay &= moving.all_stay;
  }
  return all_stay;
}

template <class D, class Kernel, bool affine, bool last, class Law>
void strain_move_and_map(const LaneWork& work, LaneFindings& found) {
  Putting<D, Kernel, 5> momenta(work.grid.nx);
  set_rows(work.N, momenta);
  Forces<D, Kernel, Law::about_axis> forces(work);
  const auto each = [&](Tile& tile, std::ptrdiff_t n) HWY_ATTR {
    const bool all_stay = strain_move_and_stress<D, Kernel, affine, last, Law>(work, n, tile, found);
    if constexpr (Law::is_gas) note_waves<D>(work, tile, found);
    if constexpr (Law::is_gas) record_stress<D, Law::about_axis>(work, tile);
    if constexpr (affine && last) record_motion<D>(work, tile);
    if (!all_stay) take_out<false>(work, tile, found);
    momenta.begin(n);
    Kernel::template scatter_momenta<D, affine>(tile, momenta);
    forces.put(tile, n);
  };
  sweep(work, each, [&]() HWY_ATTR { momenta.close(), forces.close(); });
}

// The same where a law waits for its neighbours' new places: the strain rates stand in the points' arrays meanwhile.

/// In the place of a law: it keeps the strain rate.
template <class D, class Kernel, bool axis>
class Keeping {
 public:
  static constexpr bool about_axis = axis;

  HWY_INLINE Keeping(const LaneWork& work, std::ptrdiff_t, std::size_t) : P_(work.P) {}
  HWY_INLINE void stress(const Tile& tile, std::size_t k, std::size_t sub, const typename Kernel::template Weights<D>&,
                         const Rates<D>& rate, LaneFindings&) const {
    const std::size_t p = tile.slot[k] + sub;
    store<D>(rate.xx, P_.dxx + p), store<D>(rate.yy, P_.dyy + p), store<D>(all<D>(0.5) * rate.xy, P_.dxy + p);
    store<D>(axis ? rate.zz : hn::Zero(D()), P_.dzz + p);
  }

 private:
  LanePoints P_;
};

template <class D, class Kernel, bool affine, bool axis, bool last>
void strain_and_move(const LaneWork& work, LaneFindings& found) {
  const auto each = [&](Tile& tile, std::ptrdiff_t n) HWY_ATTR {
    const bool all_stay =
        strain_move_and_stress<D, Kernel, affine, last, Keeping<D, Kernel, axis>>(work, n, tile, found);
    if constexpr (affine && last) record_motion<D>(work, tile);
    if (!all_stay) take_out<false>(work, tile, found);
  };
  sweep(work, each, []() {});
}

template <class D, class Kernel, bool affine, class Law>
HWY_NOINLINE void stress(const LaneWork& work, std::ptrdiff_t n, Tile& tile, LaneFindings& found) {
  const LanePoints P = work.P;
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    const Locating<D, Kernel> locating(work.grid, tile, sub);
    const Law law(work, n, sub);
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const std::size_t p = tile.slot[k] + sub;
      const V<D> mass = load<D>(P.mass + p);
      const Places<D> at = locating.inside(load<D>(P.x + p), load<D>(P.y + p));
      const Rates<D> rate{load<D>(P.dxx + p), load<D>(P.dyy + p), all<D>(2) * load<D>(P.dxy + p), load<D>(P.dzz + p)};
      leave_momenta<D, Kernel, affine>(tile, k, sub, mass, mass > hn::Zero(D()), at, motion_of<D, affine>(work, p));
      law.stress(tile, k, sub, Kernel::template weights<D>(at), rate, found);
    }
  }
}

template <class D, class Kernel, bool affine, class Law>
void stress_and_map(const LaneWork& work, LaneFindings& found) {
  Putting<D, Kernel, 5> momenta(work.grid.nx);
  set_rows(work.N, momenta);
  Forces<D, Kernel, Law::about_axis> forces(work);
  const auto each = [&](Tile& tile, std::ptrdiff_t n) HWY_ATTR {
    stress<D, Kernel, affine, Law>(work, n, tile, found);
    note_waves<D>(work, tile, found), record_stress<D, Law::about_axis>(work, tile);
    momenta.begin(n);
    Kernel::template scatter_momenta<D, affine>(tile, momenta);
    forces.put(tile, n);
  };
  sweep(work, each, [&]() HWY_ATTR { momenta.close(), forces.close(); });
}

}  // namespace tether::mpm::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
