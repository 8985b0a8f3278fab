// SPDX-License-Identifier: GPL-3.0-or-later
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "physics/points/lanes/passes.cpp"
#include <hwy/foreach_target.h>
// After the line above, which reads this file again for each instruction set.
#include <hwy/highway.h>

#include <algorithm>
#include <iterator>

#include "loops/lanes-inl.hpp"
#include "physics/points/lanes/bilinear-inl.hpp"
#include "physics/points/lanes/books-inl.hpp"
#include "physics/points/lanes/laws-inl.hpp"
#include "physics/points/lanes/move-inl.hpp"
#include "physics/points/lanes/spline-inl.hpp"
#include "physics/points/lanes/straining-inl.hpp"
#include "physics/points/lanes/tile-inl.hpp"
#include "physics/points/lanes/work.hpp"

HWY_BEFORE_NAMESPACE();
namespace tether::mpm::HWY_NAMESPACE {

/// Calls each(tile, n) for the points of all groups, n the node of a group's first cell, and done() after each strip.
template <class Each, class Done>
HWY_INLINE void sweep(const LaneWork& work, const Each& each, const Done& done) {
  const Blocks& blocks = *work.blocks;
  Tile tile;
  for (auto& layer : tile.lost) std::fill(std::begin(layer), std::end(layer), 0.0);
  for (const Blocks::Strip strip : blocks.strips()) {
    for (std::size_t g = strip.begin; g < strip.end; ++g) {
      const Blocks::Group& group = blocks.groups()[g];
      tile.x0 = group.cell, tile.y0 = group.row;
      for (std::uint32_t block = group.first; next_layers(blocks, block, tile);)
        each(tile, group.row * work.grid.nx + group.cell);
    }
    done();
  }
}

/// Internal forces to the nodes (3.16), about an axis with the hoop's.
template <class D, class Kernel, bool axis>
class Forces {
 public:
  HWY_INLINE explicit Forces(const LaneWork& work) : rows_(work.grid.nx) {
    rows_.rows[0] = work.N.force_x, rows_.rows[1] = work.N.force_y;
    if constexpr (axis) rows_.rows[2] = work.N.force_x;
  }
  HWY_INLINE void put(const Tile& tile, std::ptrdiff_t n) {
    rows_.begin(n);
    Kernel::template scatter_forces<D>(tile, rows_);
    if constexpr (axis) Kernel::template scatter_value<D>(tile, tile.hoop, rows_, 2);
  }
  HWY_INLINE void close() { rows_.close(); }

 private:
  Putting<D, Kernel, axis ? 3 : 2> rows_;
};

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
    const Straining<D, Kernel, axis, true> strain(work.grid, {N.old_x + n, N.old_y + n, N.new_x + n, N.new_y + n},
                                                  sub);
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

template <class D, class Kernel>
HWY_INLINE void set_rows(const LaneNodes& N, Putting<D, Kernel, 5>& momenta) {
  momenta.rows[row_of_m] = N.m, momenta.rows[row_of_x] = N.momentum_x, momenta.rows[row_of_y] = N.momentum_y;
  momenta.rows[row_of_gas] = N.gas, momenta.rows[row_of_loss] = N.loss;
  momenta.used = N.loss ? 5 : N.gas ? 4 : 3;
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

template <class D, class Kernel, bool affine, bool axis>
LanePasses passes_of(StressOrder order) {
  using Solid = Elastic<D, Kernel, axis>;
  using GasOfNodes = Gas<D, Kernel, axis, true>;
  using GasOfContinuity = Gas<D, Kernel, axis, false>;
  if (order == StressOrder::musl)
    return {.accelerate_and_convect = accelerate_and_convect<D, Kernel, affine>,
            .strain_move_and_map = {strain_move_and_map<D, Kernel, affine, false, Solid>, nullptr,
                                    strain_move_and_map<D, Kernel, affine, false, GasOfContinuity>}};
  if (order == StressOrder::usl)
    return {.strain_move_and_map = {strain_move_and_map<D, Kernel, affine, true, Solid>, nullptr,
                                    strain_move_and_map<D, Kernel, affine, true, GasOfContinuity>}};
  LanePasses passes{.strain_and_pull = {strain_and_pull<D, Kernel, Solid>, strain_and_pull<D, Kernel, GasOfNodes>,
                                        strain_and_pull<D, Kernel, GasOfContinuity>},
                    .accelerate_move_and_map = accelerate_move_and_map<D, Kernel, affine, axis, false>};
  if constexpr (affine && Kernel::lines == Spline::lines)  // the ledger asks for them
    passes.accelerate_book_move_and_map = accelerate_move_and_map<D, Kernel, affine, axis, true>;
  return passes;
}
template <class Kernel, bool affine>
LanePasses passes_of(const LaneScheme& scheme) {
  return scheme.about_axis ? passes_of<All, Kernel, affine, true>(scheme.order)
                           : passes_of<All, Kernel, affine, false>(scheme.order);
}
LanePasses passes_over_points(const LaneScheme& scheme) {
  if (scheme.kernel == tether::Kernel::linear)
    return scheme.affine ? passes_of<Bilinear, true>(scheme) : passes_of<Bilinear, false>(scheme);
  return scheme.affine ? passes_of<Spline, true>(scheme) : passes_of<Spline, false>(scheme);
}

}  // namespace tether::mpm::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace tether::mpm {

LanePasses lane_passes(InstructionSet set, const LaneScheme& scheme) {
  switch (set) {
    case InstructionSet::avx512:
      return N_AVX3::passes_over_points(scheme);
    case InstructionSet::avx2:
      return N_AVX2::passes_over_points(scheme);
    case InstructionSet::sse2:
      return N_SSSE3::passes_over_points(scheme);
    case InstructionSet::one:
      break;
  }
  return N_SCALAR::passes_over_points(scheme);
}

}  // namespace tether::mpm

#endif
