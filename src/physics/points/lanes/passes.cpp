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
template <class D, class Kernel, bool affine, bool last>
LanePasses passes_that_move() {
  return {.accelerate_and_convect = last ? nullptr : accelerate_and_convect<D, Kernel, affine>,
          .strain_move_and_map = strain_move_and_map<D, Kernel, affine, last>,
          .strain_and_move = strain_and_move<D, Kernel, affine, last>,
          .stress_and_map = stress_and_map<D, Kernel, affine>};
}
/// Updated stress first.
template <class D, class Kernel, bool affine, bool axis>
LanePasses passes_that_stay() {
  LanePasses passes{.strain_and_pull = {strain_and_pull<D, Kernel, Elastic<D, axis>>,
                                        strain_and_pull<D, Kernel, Gas<D, axis, LaneLaw::gas_of_nodes>>,
                                        strain_and_pull<D, Kernel, Gas<D, axis, LaneLaw::gas_of_continuity>>,
                                        strain_and_pull<D, Kernel, Gas<D, axis, LaneLaw::gas_of_cells>>,
                                        strain_and_pull<D, Kernel, OneByOne<D, axis>>},
                    .accelerate_move_and_map = accelerate_move_and_map<D, Kernel, affine, false>};
  if constexpr (affine && Kernel::lines == Spline::lines)  // the ledger asks for them
    passes.accelerate_book_move_and_map = accelerate_move_and_map<D, Kernel, affine, true>;
  return passes;
}
template <class Kernel, bool affine>
LanePasses passes_of(StressOrder order, Geometry geometry) {
  if (order == StressOrder::musl) return passes_that_move<All, Kernel, affine, false>();
  if (order == StressOrder::usl) return passes_that_move<All, Kernel, affine, true>();
  return geometry == Geometry::axisymmetric ? passes_that_stay<All, Kernel, affine, true>()
                                            : passes_that_stay<All, Kernel, affine, false>();
}
template <class Kernel>
LanePasses passes_of(const Method& method, Geometry geometry) {
  return method.transfer == Transfer::apic ? passes_of<Kernel, true>(method.order, geometry)
                                           : passes_of<Kernel, false>(method.order, geometry);
}
LanePasses passes_over_points(const Method& method, Geometry geometry) {
  return method.kernel == tether::Kernel::linear ? passes_of<Bilinear>(method, geometry)
                                                 : passes_of<Spline>(method, geometry);
}

}  // namespace tether::mpm::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace tether::mpm {

LanePasses lane_passes(InstructionSet set, const Method& method, Geometry geometry) {
  switch (set) {
    case InstructionSet::avx512:
      return N_AVX3::passes_over_points(method, geometry);
    case InstructionSet::avx2:
      return N_AVX2::passes_over_points(method, geometry);
    case InstructionSet::sse2:
#ifdef TETHER_SSE
      return N_SSSE3::passes_over_points(method, geometry);
#endif
    case InstructionSet::one:
      break;
  }
  return N_SCALAR::passes_over_points(method, geometry);
}

}  // namespace tether::mpm

#endif
