// SPDX-License-Identifier: GPL-3.0-or-later
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "physics/points/lanes/passes.cpp"
#include <hwy/foreach_target.h>
// After the line above, which reads this file again for each instruction set.
#include <hwy/highway.h>

#include "loops/lanes-inl.hpp"
#include "physics/points/lanes/bilinear-inl.hpp"
#include "physics/points/lanes/spline-inl.hpp"
#include "physics/points/lanes/stress_first-inl.hpp"
#include "physics/points/lanes/stress_last-inl.hpp"
#include "physics/points/lanes/work.hpp"

HWY_BEFORE_NAMESPACE();
namespace tether::mpm::HWY_NAMESPACE {

/// Orders whose points move before their stress; `last`: velocities were not mapped back.
template <class D, class Kernel, bool affine, bool axis, bool last>
LanePasses passes_that_move() {
  using Solid = Elastic<D, Kernel, axis>;
  using OfNodes = Gas<D, Kernel, axis, LaneLaw::gas_of_nodes>;
  using OfContinuity = Gas<D, Kernel, axis, LaneLaw::gas_of_continuity>;
  using OfCells = Gas<D, Kernel, axis, LaneLaw::gas_of_cells>;
  return {.accelerate_and_convect = last ? nullptr : accelerate_and_convect<D, Kernel, affine>,
          .strain_move_and_map = {strain_move_and_map<D, Kernel, affine, last, Solid>, nullptr,
                                  strain_move_and_map<D, Kernel, affine, last, OfContinuity>},
          .strain_and_move = strain_and_move<D, Kernel, affine, axis, last>,
          .stress_and_map = {nullptr, stress_and_map<D, Kernel, affine, OfNodes>, nullptr,
                             stress_and_map<D, Kernel, affine, OfCells>}};
}
template <class D, class Kernel, bool affine, bool axis>
LanePasses passes_of(StressOrder order) {
  if (order == StressOrder::musl) return passes_that_move<D, Kernel, affine, axis, false>();
  if (order == StressOrder::usl) return passes_that_move<D, Kernel, affine, axis, true>();
  LanePasses passes{.strain_and_pull = {strain_and_pull<D, Kernel, Elastic<D, Kernel, axis>>,
                                        strain_and_pull<D, Kernel, Gas<D, Kernel, axis, LaneLaw::gas_of_nodes>>,
                                        strain_and_pull<D, Kernel, Gas<D, Kernel, axis, LaneLaw::gas_of_continuity>>,
                                        strain_and_pull<D, Kernel, Gas<D, Kernel, axis, LaneLaw::gas_of_cells>>},
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
