// SPDX-License-Identifier: GPL-3.0-or-later
// Read once for each instruction set, so without #pragma once.
#if defined(TETHER_POINTS_MOVE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TETHER_POINTS_MOVE_INL
#undef TETHER_POINTS_MOVE_INL
#else
#define TETHER_POINTS_MOVE_INL
#endif

#include <bit>
#include <cstdint>
#include <type_traits>

#include "physics/points/lanes/books-inl.hpp"
#include "physics/points/lanes/tile-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tether::mpm::HWY_NAMESPACE {

// What passes share whatever the kernel: velocities, places, what is written of them, and who leaves.

/// Places of a tile's points into it.
template <class D, class Kernel>
HWY_NOINLINE void locate(const LaneWork& work, Tile& tile) {
  const LanePoints P = work.P;
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    const Locating<D, Kernel> locating(work.grid, tile, sub);
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const std::size_t p = tile.slot[k] + sub;
      const Places<D> at = locating.inside(load<D>(P.x + p), load<D>(P.y + p));
      store<D>(at.r, tile.r[k] + sub), store<D>(at.s, tile.s[k] + sub);
    }
  }
}

/// A number of the nodes at a tile's points, which are located.
template <class D, class Kernel>
HWY_NOINLINE void gather_value(const double* row, std::ptrdiff_t nx, const Tile& tile, TileRows& values) {
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    const typename Kernel::template Value<D> value(row, nx, sub);
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const auto w = Kernel::template weights<D>({load<D>(tile.r[k] + sub), load<D>(tile.s[k] + sub)});
      store<D>(value.at(w), values[k] + sub);
    }
  }
}
/// Does the same for velocities and the fields about points.
template <class D, class Kernel>
HWY_NOINLINE void gather_motion(const double* row_x, const double* row_y, std::ptrdiff_t nx, Tile& tile) {
  for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
    const typename Kernel::template Fields<D> fields(row_x, row_y, nx, sub);
    for (std::size_t k = 0; k < tile.layers; ++k) {
      const auto w = Kernel::template weights<D>({load<D>(tile.r[k] + sub), load<D>(tile.s[k] + sub)});
      store_motion<D>(fields.at(w), tile, k, sub);
    }
  }
}

/// A layer's new velocities (3.22), and what it moves with.
template <class D>
struct Taken {
  Motion<D> motion;  // by FLIP the velocity alone
  V<D> ux, uy;
};

/// FLIP: v_p += dt sum N_i f_i / m_i (3.22), with m_p |a_p|^2 for the balance of energy; points move with
/// sum N_i (mv)_i^L / m_i. Where points have taken their increments already, only what they move with is new.
template <class D, class Kernel, bool accelerates>
class TakingIncrements {
 public:
  HWY_INLINE TakingIncrements(const LaneWork& work, std::ptrdiff_t n, std::size_t sub)
      : dt_(all<D>(work.dt)),
        a_x_(work.N.a_x + n, work.grid.nx, sub),
        a_y_(work.N.a_y + n, work.grid.nx, sub),
        u_x_(work.N.new_x + n, work.grid.nx, sub),
        u_y_(work.N.new_y + n, work.grid.nx, sub) {}

  HWY_INLINE Taken<D> take(const LanePoints& P, std::size_t p, V<D> mass, const typename Kernel::template Weights<D>& w,
                           V<D>& squares) const {
    Taken<D> taken;
    taken.motion.vx = load<D>(P.vx + p), taken.motion.vy = load<D>(P.vy + p);
    if constexpr (accelerates) accelerate(P, p, mass, w, taken.motion, squares);
    taken.ux = u_x_.at(w), taken.uy = u_y_.at(w);
    return taken;
  }
  HWY_INLINE void accelerate(const LanePoints& P, std::size_t p, V<D> mass,
                             const typename Kernel::template Weights<D>& w, Motion<D>& motion, V<D>& squares) const {
    const V<D> ax = a_x_.at(w), ay = a_y_.at(w);
    const auto there = mass > hn::Zero(D());
    motion.vx = hn::IfThenElseZero(there, motion.vx + dt_ * ax);
    motion.vy = hn::IfThenElseZero(there, motion.vy + dt_ * ay);
    store<D>(motion.vx, P.vx + p), store<D>(motion.vy, P.vy + p);
    squares = squares + mass * (ax * ax + ay * ay);
  }

 private:
  V<D> dt_;
  typename Kernel::template Value<D> a_x_, a_y_, u_x_, u_y_;
};

/// Returns what points carry: their velocity, and by APIC the field about them.
template <class D, bool affine>
HWY_INLINE Motion<D> motion_of(const LaneWork& work, std::size_t p) {
  Motion<D> motion;
  if constexpr (affine) {
    V<D> own[6];
    own_field<D>(work, p, own);
    motion = {own[0], own[1], own[2], own[3], own[4], own[5]};
  } else {
    motion.vx = load<D>(work.P.vx + p), motion.vy = load<D>(work.P.vy + p);
  }
  return motion;
}

/// APIC: a point's field is that of the nodes about it, and its velocity is what it moves with.
template <class D, class Kernel, bool accelerates>
class TakingFields {
 public:
  HWY_INLINE TakingFields(const LaneWork& work, std::ptrdiff_t n, std::size_t sub)
      : work_(work), fields_(work.N.new_x + n, work.N.new_y + n, work.grid.nx, sub) {}

  HWY_INLINE Taken<D> take(const LanePoints&, std::size_t p, V<D>, const typename Kernel::template Weights<D>& w,
                           V<D>&) const {
    Taken<D> taken;
    if constexpr (accelerates)
      taken.motion = fields_.at(w);
    else
      taken.motion = motion_of<D, true>(work_, p);
    taken.ux = taken.motion.vx, taken.uy = taken.motion.vy;
    return taken;
  }

 private:
  const LaneWork& work_;
  typename Kernel::template Fields<D> fields_;
};

template <class D, class Kernel, bool affine, bool accelerates>
using Taking =
    std::conditional_t<affine, TakingFields<D, Kernel, accelerates>, TakingIncrements<D, Kernel, accelerates>>;

/// Points of a layer at their new places: those that have left their cells have no mass here, and their places are in
/// the middle.
template <class D>
struct Arrived {
  V<D> x, mass;
  Places<D> at;
  hn::Mask<D> stay;
};

/// Takes layers to their new places (3.21).
template <class D, class Kernel>
class Moving {
 public:
  HWY_INLINE Moving(const LaneWork& work, const LaneFindings& found, std::size_t sub)
      : lifted(load<D>(found.lifted + sub)), dt_(all<D>(work.dt)) {}

  V<D> lifted;  // mass times the way up

  /// Notes in the tile who has left.
  HWY_INLINE Arrived<D> move(const LanePoints& P, const Locating<D, Kernel>& locating, Tile& tile, std::size_t k,
                             std::size_t sub, const Layer<D>& layer, const Taken<D>& taken) {
    const V<D> up = dt_ * taken.uy;
    const auto there = layer.mass > hn::Zero(D());
    lifted = lifted + layer.mass * up;
    const V<D> x = layer.x + hn::IfThenElseZero(there, dt_ * taken.ux), y = layer.y + hn::IfThenElseZero(there, up);
    store<D>(x, P.x + layer.p), store<D>(y, P.y + layer.p);
    const Places<D> at = locating.anywhere(x, y);
    const auto stay = stays(at);
    if (HWY_UNLIKELY(!hn::AllTrue(D(), stay))) note_left(tile, k, sub, stay);
    return {x, hn::IfThenElseZero(stay, layer.mass),
            inside(hn::IfThenElseZero(stay, at.r), hn::IfThenElseZero(stay, at.s)), stay};
  }

 private:
  static HWY_INLINE hn::Mask<D> stays(Places<D> at) {
    const V<D> lowest = all<D>(Kernel::lowest), highest = all<D>(Kernel::highest);
    return hn::And(hn::And(at.r >= lowest, at.r < highest), hn::And(at.s >= lowest, at.s < highest));
  }
  static HWY_INLINE Places<D> inside(V<D> r, V<D> s) {
    return {Kernel::template inside<D>(r), Kernel::template inside<D>(s)};
  }
  static HWY_INLINE void note_left(Tile& tile, std::size_t k, std::size_t sub, hn::Mask<D> stay) {
    std::uint8_t bits[8];
    hn::StoreMaskBits(D(), hn::Not(stay), bits);
    tile.left[k] = static_cast<std::uint8_t>(tile.left[k] | bits[0] << sub), tile.some_left = true;
  }
  V<D> dt_;
};

/// The tile's velocities and fields to the points' arrays.
template <class D>
HWY_INLINE void record_motion(const LaneWork& work, const Tile& tile, std::size_t k, std::size_t sub) {
  const std::size_t p = tile.slot[k] + sub;
  const V<D> per_dx = all<D>(work.grid.per_dx), per_dy = all<D>(work.grid.per_dy);
  store<D>(load<D>(tile.vx[k] + sub), work.P.vx + p), store<D>(load<D>(tile.vy[k] + sub), work.P.vy + p);
  store<D>(per_dx * load<D>(tile.gxx[k] + sub), work.P.vxx + p);
  store<D>(per_dx * load<D>(tile.gyx[k] + sub), work.P.vyx + p);
  store<D>(per_dy * load<D>(tile.gxy[k] + sub), work.P.vxy + p);
  store<D>(per_dy * load<D>(tile.gyy[k] + sub), work.P.vyy + p);
}
template <class D>
HWY_NOINLINE void record_motion(const LaneWork& work, const Tile& tile) {
  for (std::size_t k = 0; k < tile.layers; ++k) {
    for (std::size_t sub = 0; sub < lanes; sub += width<D>) record_motion<D>(work, tile, k, sub);
  }
}
/// Records the stress of gas itself, and not the stress over the density.
template <class D>
HWY_NOINLINE void record_stress(const LaneWork& work, const Tile& tile) {
  for (std::size_t k = 0; k < tile.layers; ++k) {
    for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
      const std::size_t p = tile.slot[k] + sub;
      const V<D> rho = load<D>(work.P.rho + p);
      for (double* stress : {work.P.sxx, work.P.syy, work.P.sxy}) store<D>(rho * load<D>(stress + p), stress + p);
      if (work.about_axis) store<D>(rho * load<D>(work.P.szz + p), work.P.szz + p);
    }
  }
}

/// Takes out the points of a tile that have left their cells: they are noted, the first of them with all their numbers,
/// and what they have lost belongs to where they are now. By APIC without records the fields about them are written
/// first.
template <bool affine, bool books = false>
HWY_NOINLINE void take_out(const LaneWork& work, Tile& tile, LaneFindings& found) {
  for (std::size_t k = 0; k < tile.layers; ++k) {
    for (unsigned left = tile.left[k]; left != 0; left &= left - 1) {
      const auto l = static_cast<std::size_t>(std::countr_zero(left));
      if (affine && !work.records) record_motion<One>(work, tile, k, l);
      const std::size_t p = tile.slot[k] + l;
      const Blocks::Cell cell{static_cast<int>(tile.y0), static_cast<int>(tile.x0) + static_cast<int>(l)};
      found.moved.push_back({p, cell, books ? tile.lost[k][l] : 0});
      if (books) tile.lost[k][l] = 0;
      if (found.moved.size() > LaneFindings::most_noted) continue;
      for (const double* array : work.arrays) found.numbers.push_back(array[p]);
    }
  }
}

}  // namespace tether::mpm::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
