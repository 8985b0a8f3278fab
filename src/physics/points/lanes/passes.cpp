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

// Updated stress first, first pass: strain rate (3.23), stress, force (3.16).

template <class D, class Kernel, class Law>
void strain_and_pull(const LaneWork& work, LaneFindings& found) {
  const LaneNodes& N = work.N;
  Putting<D, Kernel, 2> forces(work.grid.nx);
  forces.rows[0] = N.force_x, forces.rows[1] = N.force_y;
  const auto each = [&](Tile& tile, std::ptrdiff_t n) HWY_ATTR {
    locate<D, Kernel>(work, tile);
    Kernel::template gather_strain<D, false>(work.grid, {N.old_x + n, N.old_y + n}, tile);
    find_at_nodes<D, Kernel, Law>(work, n, tile);
    stress<D, Kernel, Law>(work, tile, found);
    forces.begin(n);
    Kernel::template scatter_forces<D>(tile, forces);
  };
  sweep(work, each, [&]() HWY_ATTR { forces.close(); });
}

// Second pass: velocities (3.22), places (3.21), mass and momentum (3.15).

template <class D, class Kernel, bool affine, bool books>
HWY_INLINE void accelerate_and_move(const LaneWork& work, std::ptrdiff_t n, Tile& tile, LaneFindings& found) {
  const LaneNodes& N = work.N;
  const bool is_gas = work.body.law != LaneLaw::elastic;
  locate<D, Kernel>(work, tile);
  if (is_gas && !work.body.heats) {
    Kernel::template gather_strain<D, true>(work.grid, {N.old_x + n, N.old_y + n, N.new_x + n, N.new_y + n}, tile);
    heat_centred<D>(work, tile);
  }
  if constexpr (books) {
    Kernel::template gather_motion<D>(N.old_x + n, N.old_y + n, work.grid.nx, tile);
    book_way_there<D>(work, tile);
    Kernel::template gather_value<D>(N.squares + n, work.grid.nx, tile, tile.at_place);
  }
  if constexpr (affine)
    Kernel::template gather_motion<D>(N.new_x + n, N.new_y + n, work.grid.nx, tile);
  else
    accelerate_by_increments<D, Kernel>(work, n, tile, found);
  find_way<D, Kernel, affine>(work, n, tile);
  const bool all_stay = move<D, Kernel, affine>(work, tile, found);
  if constexpr (books) book_way_back<D>(work, tile, found);
  if (is_gas) note_waves<D>(work, tile, found);
  if (affine && work.records) record_motion<D>(work, tile);
  if (is_gas && work.records) record_stress<D>(work, tile);
  if (!all_stay) take_out<affine>(work, tile, found);
}

template <class D, class Kernel>
HWY_INLINE void set_rows(const LaneNodes& N, Putting<D, Kernel, 5>& momenta) {
  momenta.rows[row_of_m] = N.m, momenta.rows[row_of_x] = N.momentum_x, momenta.rows[row_of_y] = N.momentum_y;
  momenta.rows[row_of_gas] = N.gas, momenta.rows[row_of_loss] = N.loss;
  momenta.used = N.loss ? 5 : N.gas ? 4 : 3;
}

template <class D, class Kernel, bool affine, bool books>
void accelerate_move_and_map(const LaneWork& work, LaneFindings& found) {
  Putting<D, Kernel, 5> momenta(work.grid.nx);
  set_rows(work.N, momenta);
  const auto each = [&](Tile& tile, std::ptrdiff_t n) HWY_ATTR {
    accelerate_and_move<D, Kernel, affine, books>(work, n, tile, found);
    momenta.begin(n);
    Kernel::template scatter_momenta<D, affine>(tile, momenta);
    if constexpr (books) {
      if (momenta.used > row_of_loss) Kernel::template scatter_value<D>(tile, tile.lost, momenta, row_of_loss);
    }
  };
  sweep(work, each, [&]() HWY_ATTR { momenta.close(); });
}

// Updated stress last: velocities (3.22), and their momenta back on the nodes (3.24).

template <class D, class Kernel, bool affine>
HWY_INLINE void accelerate(const LaneWork& work, std::ptrdiff_t n, Tile& tile, LaneFindings& found) {
  if constexpr (affine) {
    Kernel::template gather_motion<D>(work.N.new_x + n, work.N.new_y + n, work.grid.nx, tile);
    record_motion<D>(work, tile);
  } else {
    accelerate_by_increments<D, Kernel>(work, n, tile, found);
  }
}

template <class D, class Kernel, bool affine>
void accelerate_and_convect(const LaneWork& work, LaneFindings& found) {
  Putting<D, Kernel, 2> momenta(work.grid.nx);
  momenta.rows[row_of_x] = work.N.convected_x, momenta.rows[row_of_y] = work.N.convected_y;
  const auto each = [&](Tile& tile, std::ptrdiff_t n) HWY_ATTR {
    locate<D, Kernel>(work, tile);
    accelerate<D, Kernel, affine>(work, n, tile, found);
    leave_momenta<D, Kernel, affine>(work, tile);
    momenta.begin(n);
    Kernel::template scatter_momenta<D, affine>(tile, momenta);
  };
  sweep(work, each, [&]() HWY_ATTR { momenta.close(); });
}

// Strain rate at the old place (3.23), new place (3.21), stress, and the map to the new place's nodes (3.15), (3.16).

template <class D, class Kernel, bool affine, bool convects, class Law>
HWY_INLINE void strain_and_move(const LaneWork& work, std::ptrdiff_t n, Tile& tile, LaneFindings& found) {
  const LaneNodes& N = work.N;
  locate<D, Kernel>(work, tile);
  if constexpr (convects) {
    Kernel::template gather_strain<D, false>(work.grid, {N.old_x + n, N.old_y + n}, tile);
    recall_motion<D, affine>(work, tile);
  } else {
    Kernel::template gather_strain<D, false>(work.grid, {N.new_x + n, N.new_y + n}, tile);
    accelerate<D, Kernel, affine>(work, n, tile, found);
  }
  find_at_nodes<D, Kernel, Law>(work, n, tile);
  find_way<D, Kernel, affine>(work, n, tile);
  const bool all_stay = move<D, Kernel, affine>(work, tile, found);
  stress<D, Kernel, Law>(work, tile, found);
  if constexpr (Law::is_gas) note_waves<D>(work, tile, found);
  if constexpr (Law::is_gas) record_stress<D>(work, tile);
  if (!all_stay) take_out<false>(work, tile, found);
}

template <class D, class Kernel, bool affine, bool convects, class Law>
void strain_move_and_map(const LaneWork& work, LaneFindings& found) {
  Putting<D, Kernel, 5> momenta(work.grid.nx);
  set_rows(work.N, momenta);
  Putting<D, Kernel, 2> forces(work.grid.nx);
  forces.rows[0] = work.N.force_x, forces.rows[1] = work.N.force_y;
  const auto each = [&](Tile& tile, std::ptrdiff_t n) HWY_ATTR {
    strain_and_move<D, Kernel, affine, convects, Law>(work, n, tile, found);
    momenta.begin(n), forces.begin(n);
    Kernel::template scatter_momenta<D, affine>(tile, momenta);
    Kernel::template scatter_forces<D>(tile, forces);
  };
  sweep(work, each, [&]() HWY_ATTR { momenta.close(), forces.close(); });
}

template <class D, class Kernel, bool affine>
LanePasses passes_of(StressOrder order) {
  if (order == StressOrder::musl)
    return {.accelerate_and_convect = accelerate_and_convect<D, Kernel, affine>,
            .strain_move_and_map = {strain_move_and_map<D, Kernel, affine, true, Elastic<D>>, nullptr,
                                    strain_move_and_map<D, Kernel, affine, true, Gas<D, false>>}};
  if (order == StressOrder::usl)
    return {.strain_move_and_map = {strain_move_and_map<D, Kernel, affine, false, Elastic<D>>, nullptr,
                                    strain_move_and_map<D, Kernel, affine, false, Gas<D, false>>}};
  LanePasses passes{
      .strain_and_pull = {strain_and_pull<D, Kernel, Elastic<D>>, strain_and_pull<D, Kernel, Gas<D, true>>,
                          strain_and_pull<D, Kernel, Gas<D, false>>},
      .accelerate_move_and_map = accelerate_move_and_map<D, Kernel, affine, false>};
  if constexpr (affine && Kernel::lines == Spline::lines)  // the ledger asks for them
    passes.accelerate_book_move_and_map = accelerate_move_and_map<D, Kernel, affine, true>;
  return passes;
}
LanePasses passes_over_points(const LaneScheme& scheme) {
  if (scheme.kernel == tether::Kernel::linear)
    return scheme.affine ? passes_of<All, Bilinear, true>(scheme.order) : passes_of<All, Bilinear, false>(scheme.order);
  return scheme.affine ? passes_of<All, Spline, true>(scheme.order) : passes_of<All, Spline, false>(scheme.order);
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
