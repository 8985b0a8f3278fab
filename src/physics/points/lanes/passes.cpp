// SPDX-License-Identifier: GPL-3.0-or-later
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "physics/points/lanes/passes.cpp"
#include <hwy/foreach_target.h>
// After the line above, which reads this file again for each instruction set.
#include <hwy/highway.h>

#include "loops/lanes-inl.hpp"
#include "physics/points/lanes/books-inl.hpp"
#include "physics/points/lanes/laws-inl.hpp"
#include "physics/points/lanes/spline-inl.hpp"
#include "physics/points/lanes/tile-inl.hpp"
#include "physics/points/lanes/work.hpp"

HWY_BEFORE_NAMESPACE();
namespace tether::mpm::HWY_NAMESPACE {

/// Node of a group's first cell.
inline std::ptrdiff_t node_of(const LaneWork& work, const Blocks::Group& group) {
  return group.row * work.grid.nx + group.cell;
}

inline void begin_group(const Blocks::Group& group, Tile& tile) { tile.x0 = group.cell, tile.y0 = group.row; }

// usf, first pass: strain rate, stress, force.

template <class D>
HWY_NOINLINE void strain_and_stress(const LaneWork& work, std::ptrdiff_t n, Tile& tile, LaneFindings& found) {
  locate<D>(work, tile);
  gather_gradient<D, false>(work.grid, {work.N.old_x + n, work.N.old_y + n}, tile);
  if (work.body.law == LaneLaw::elastic) return elastic<D>(work, tile, found);
  gather_value<D>(work.N.rho + n, work.grid.nx, tile, tile.rho);
  if (work.N.heat) gather_value<D>(work.N.heat + n, work.grid.nx, tile, tile.heat);
  gas<D>(work, tile, found);
}

template <class D>
void strain_and_pull(const LaneWork& work, LaneFindings& found) {
  const Blocks& blocks = *work.blocks;
  Tile tile;
  for (const Blocks::Strip strip : blocks.strips()) {
    Putting<D, 2> putting{{work.N.force_x, work.N.force_y}, work.grid.nx};
    for (std::size_t g = strip.begin; g < strip.end; ++g) {
      const Blocks::Group& group = blocks.groups()[g];
      const std::ptrdiff_t n = node_of(work, group);
      begin_group(group, tile);
      alignas(64) PullSums sums = {};
      for (std::uint32_t block = group.first; next_layers(blocks, block, tile);) {
        strain_and_stress<D>(work, n, tile, found);
        scatter_forces<D>(tile, sums);
      }
      putting.begin(n);
      for (std::size_t c = 0; c < 2; ++c) {
        alignas(64) NineSums nine;
        nine_forces<D>(sums[c], nine);
        putting.put(c, nine);
      }
    }
    putting.close();
  }
}

// usf, second pass: velocities, places, mass and momentum.

/// i += dt (sigma : eps') / rho (4.10) with the strain rate of (v_old + v_new) / 2, which stands in the tile.
template <class D>
HWY_INLINE void heat_centred(const LaneWork& work, Tile& tile) {
  const V<D> dt = all<D>(work.dt), zero = hn::Zero(D());
  for (std::size_t k = 0; k < tile.layers; ++k) {
    for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
      const std::size_t p = tile.slot[k] + sub;
      const V<D> power =
          (load<D>(work.P.sxx + p) * load<D>(tile.xx[k] + sub) + load<D>(work.P.syy + p) * load<D>(tile.yy[k] + sub)) +
          load<D>(work.P.sxy + p) * (load<D>(tile.xy[k] + sub) + load<D>(tile.yx[k] + sub));
      const V<D> energy = load<D>(work.P.energy + p) + dt * power / load<D>(work.P.rho + p);
      store<D>(hn::IfThenElseZero(load<D>(work.P.mass + p) > zero, energy), work.P.energy + p);
    }
  }
}

/// Largest sound speed of the gas and largest wave.
template <class D>
HWY_INLINE void note_waves(const LaneWork& work, const Tile& tile, LaneFindings& found) {
  const V<D> c_of_e = all<D>(work.body.gamma * work.body.gm1), zero = hn::Zero(D());
  for (std::size_t k = 0; k < tile.layers; ++k) {
    for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
      const std::size_t p = tile.slot[k] + sub;
      const V<D> there = hn::VecFromMask(D(), load<D>(work.P.mass + p) > zero);
      const V<D> vx = load<D>(tile.vx[k] + sub), vy = load<D>(tile.vy[k] + sub);
      const V<D> c_squared = hn::And(there, hn::Max(zero, c_of_e * load<D>(work.P.energy + p)));
      const V<D> wave = hn::And(there, hn::Sqrt(c_squared) + hn::Sqrt(vx * vx + vy * vy));
      store<D>(hn::Max(load<D>(found.c_squared + sub), c_squared), found.c_squared + sub);
      store<D>(hn::Max(load<D>(found.wave + sub), wave), found.wave + sub);
    }
  }
}

/// The tile's field of a point to its arrays.
template <class D>
HWY_INLINE void record(const LaneWork& work, const Tile& tile, std::size_t k, std::size_t sub) {
  const std::size_t p = tile.slot[k] + sub;
  const V<D> per_dx = all<D>(work.grid.per_dx), per_dy = all<D>(work.grid.per_dy);
  store<D>(load<D>(tile.vx[k] + sub), work.P.vx + p), store<D>(load<D>(tile.vy[k] + sub), work.P.vy + p);
  store<D>(per_dx * load<D>(tile.gxx[k] + sub), work.P.vxx + p);
  store<D>(per_dx * load<D>(tile.gyx[k] + sub), work.P.vyx + p);
  store<D>(per_dy * load<D>(tile.gxy[k] + sub), work.P.vxy + p);
  store<D>(per_dy * load<D>(tile.gyy[k] + sub), work.P.vyy + p);
}

/// Points that have left their cells: they are noted, with the fields about them in their arrays, and give nothing
/// here.
template <class D, class M>
HWY_NOINLINE void take_out(const LaneWork& work, Tile& tile, std::size_t k, std::size_t sub, M stays,
                           LaneFindings& found) {
  alignas(64) double kept[lanes];
  store<D>(hn::IfThenElseZero(stays, all<D>(1)), kept);
  for (std::size_t l = 0; l < width<D>; ++l) {
    const std::size_t p = tile.slot[k] + sub + l;
    if (kept[l] != 0 || !(work.P.mass[p] > 0)) continue;
    if (!work.records) note_squares<One>(work, tile, k, sub + l, found), record<One>(work, tile, k, sub + l);
    const Blocks::Cell cell{static_cast<int>(tile.y0), static_cast<int>(tile.x0) + static_cast<int>(sub + l)};
    found.moved.push_back({p, cell, tile.lost[k][sub + l]});
  }
}

/// New places (3.21), and what the scatter needs of them.
template <class D>
HWY_INLINE void move(const LaneWork& work, Tile& tile, LaneFindings& found) {
  constexpr D d;
  const V<D> dt = all<D>(work.dt), x0 = all<D>(work.grid.x0), y0 = all<D>(work.grid.y0),
             per_dx = all<D>(work.grid.per_dx), per_dy = all<D>(work.grid.per_dy), row = all<D>(tile.y0),
             half = all<D>(0.5), minus_half = all<D>(-0.5);
  for (std::size_t k = 0; k < tile.layers; ++k) {
    for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
      const std::size_t p = tile.slot[k] + sub;
      const V<D> mass = load<D>(work.P.mass + p), vx = load<D>(tile.vx[k] + sub), vy = load<D>(tile.vy[k] + sub);
      const V<D> up = dt * vy, x = load<D>(work.P.x + p) + dt * vx, y = load<D>(work.P.y + p) + up;
      add_to<D>(found.lifted + sub, mass * up);
      if (work.records) note_squares<D>(work, tile, k, sub, found), record<D>(work, tile, k, sub);
      V<D> r = (x - x0) * per_dx - counting<D>(tile.x0 + static_cast<double>(sub)), s = (y - y0) * per_dy - row;
      const auto there = mass > hn::Zero(d);
      const auto stays =
          hn::And(there, hn::And(hn::And(r >= minus_half, r < half), hn::And(s >= minus_half, s < half)));
      store<D>(hn::IfThenElse(there, x, load<D>(work.P.x + p)), work.P.x + p);
      store<D>(hn::IfThenElse(there, y, load<D>(work.P.y + p)), work.P.y + p);
      if (HWY_UNLIKELY(!hn::AllTrue(d, stays))) take_out<D>(work, tile, k, sub, stays, found);
      r = hn::IfThenElseZero(stays, r), s = hn::IfThenElseZero(stays, s);
      const V<D> gxx = load<D>(tile.gxx[k] + sub), gxy = load<D>(tile.gxy[k] + sub);
      const V<D> gyx = load<D>(tile.gyx[k] + sub), gyy = load<D>(tile.gyy[k] + sub);
      store<D>(hn::IfThenElseZero(stays, mass), tile.m[k] + sub);
      store<D>(r, tile.r[k] + sub), store<D>(s, tile.s[k] + sub);
      store<D>(vx - (r * gxx + s * gxy), tile.middle_x[k] + sub);
      store<D>(vy - (r * gyx + s * gyy), tile.middle_y[k] + sub);
    }
  }
}

/// Lost energy of points that have left belongs to where they are now, which is no matter of this group.
template <class D>
HWY_INLINE void mask_lost(Tile& tile) {
  for (std::size_t k = 0; k < tile.layers; ++k) {
    for (std::size_t sub = 0; sub < lanes; sub += width<D>) {
      const auto stays = load<D>(tile.m[k] + sub) > hn::Zero(D());
      store<D>(hn::IfThenElseZero(stays, load<D>(tile.lost[k] + sub)), tile.lost[k] + sub);
    }
  }
}

template <class D, bool books>
HWY_NOINLINE void accelerate_and_move(const LaneWork& work, std::ptrdiff_t n, Tile& tile, LaneFindings& found) {
  const LaneNodes& N = work.N;
  const bool is_gas = work.body.law == LaneLaw::gas;
  locate<D>(work, tile);
  if (is_gas && !work.body.heats) {
    gather_gradient<D, true>(work.grid, {N.old_x + n, N.old_y + n, N.new_x + n, N.new_y + n}, tile);
    heat_centred<D>(work, tile);
  }
  if constexpr (books) {
    gather_affine<D>(N.old_x + n, N.old_y + n, work.grid.nx, tile);
    book_way_there<D>(work, tile);
  }
  gather_affine<D>(N.new_x + n, N.new_y + n, work.grid.nx, tile);
  if constexpr (books) {
    gather_value<D>(N.squares + n, work.grid.nx, tile, tile.heat);
    book_way_back<D>(work, tile, found);
  }
  if (is_gas) note_waves<D>(work, tile, found);
  move<D>(work, tile, found);
  if constexpr (books) mask_lost<D>(tile);
}

template <class D, bool books>
void accelerate_move_and_map(const LaneWork& work, LaneFindings& found) {
  const Blocks& blocks = *work.blocks;
  const bool gas_rows = work.N.gas != nullptr;
  Tile tile;
  for (const Blocks::Strip strip : blocks.strips()) {
    Putting<D, 5> putting{{work.N.m, work.N.momentum_x, work.N.momentum_y, work.N.gas, work.N.loss},
                          work.grid.nx,
                          gas_rows ? (books ? 5U : 4U) : 3U};
    for (std::size_t g = strip.begin; g < strip.end; ++g) {
      const Blocks::Group& group = blocks.groups()[g];
      const std::ptrdiff_t n = node_of(work, group);
      begin_group(group, tile);
      alignas(64) NineSums m = {}, px = {}, py = {}, loss = {};
      for (std::uint32_t block = group.first; next_layers(blocks, block, tile);) {
        accelerate_and_move<D, books>(work, n, tile, found);
        scatter_momenta<D>(tile, m, px, py);
        if constexpr (books) scatter_value<D>(tile, tile.lost, loss);
      }
      putting.begin(n);
      putting.put(0, m), putting.put(1, px), putting.put(2, py);
      if (gas_rows) putting.put(3, m);
      if (gas_rows && books) putting.put(4, loss);
    }
    putting.close();
  }
}

template <class D>
constexpr LanePasses passes_of() {
  return {strain_and_pull<D>, accelerate_move_and_map<D, false>, accelerate_move_and_map<D, true>};
}
LanePasses passes_over_points() { return passes_of<All>(); }

}  // namespace tether::mpm::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace tether::mpm {

LanePasses spline_passes(InstructionSet set) {
  switch (set) {
    case InstructionSet::avx512:
      return N_AVX3::passes_over_points();
    case InstructionSet::avx2:
      return N_AVX2::passes_over_points();
    case InstructionSet::sse2:
      return N_SSSE3::passes_over_points();
    case InstructionSet::one:
      break;
  }
  return N_SCALAR::passes_over_points();
}

}  // namespace tether::mpm

#endif
