// SPDX-License-Identifier: GPL-3.0-or-later
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "physics/points/lanes/nodes.cpp"
#include <hwy/foreach_target.h>
// After the line above, which reads this file again for each instruction set.
#include <hwy/highway.h>

#include "loops/lanes-inl.hpp"
#include "physics/points/lanes/nodes.hpp"

HWY_BEFORE_NAMESPACE();
namespace tether::mpm::HWY_NAMESPACE {

using namespace tether::HWY_NAMESPACE;

constexpr std::size_t eight = 8;

template <class D>
HWY_INLINE V<D> inverse_of(V<D> m) {
  return hn::IfThenElseZero(m > hn::Zero(D()), all<D>(1) / m);
}

/// Calls body.template at<Lanes>(n) for all active nodes: by all lanes, and one by one what is left of a span.
template <class Body>
HWY_INLINE void each_node(const ActiveNodes& active, const Body& body) {
  for (const NodeSpan span : active.spans()) {
    std::size_t n = span.begin;
    for (; n + width<All> <= span.end; n += width<All>) body.template at<All>(n);
    for (; n < span.end; ++n) body.template at<One>(n);
  }
}

struct Clear {
  std::span<double* const> rows;
  template <class D>
  HWY_INLINE void at(std::size_t n) const {
    for (double* row : rows) store<D>(hn::Zero(D()), row + n);
  }
};
void clear(std::span<double* const> rows, const ActiveNodes& active) { each_node(active, Clear{rows}); }

struct MapVelocity {
  const NodeRows& r;
  template <class D>
  HWY_INLINE void at(std::size_t n) const {
    const V<D> per_m = inverse_of<D>(load<D>(r.m + n));
    store<D>(per_m * load<D>(r.momentum_x + n), r.convected_x + n);
    store<D>(per_m * load<D>(r.momentum_y + n), r.convected_y + n);
  }
};
void map_velocity(const NodeRows& rows, const ActiveNodes& active) { each_node(active, MapVelocity{rows}); }

struct DivideConvected {
  const NodeRows& r;
  template <class D>
  HWY_INLINE void at(std::size_t n) const {
    const V<D> per_m = inverse_of<D>(load<D>(r.m + n));
    store<D>(per_m * load<D>(r.convected_x + n), r.convected_x + n);
    store<D>(per_m * load<D>(r.convected_y + n), r.convected_y + n);
  }
};
void divide_convected(const NodeRows& rows, const ActiveNodes& active) { each_node(active, DivideConvected{rows}); }

struct Solve {
  const NodeRows& r;
  double gravity, dt;
  template <class D>
  HWY_INLINE void at(std::size_t n) const {
    const V<D> per_m = inverse_of<D>(load<D>(r.m + n)), step = all<D>(dt);
    const V<D> ax = load<D>(r.force_x + n) * per_m, ay = load<D>(r.force_y + n) * per_m + all<D>(gravity);
    store<D>(ax, r.a_x + n), store<D>(ay, r.a_y + n);
    store<D>(load<D>(r.momentum_x + n) * per_m + step * ax, r.u_x + n);
    store<D>(load<D>(r.momentum_y + n) * per_m + step * ay, r.u_y + n);
  }
};
void solve(const NodeRows& rows, const ActiveNodes& active, double gravity, double dt) {
  each_node(active, Solve{rows, gravity, dt});
}

/// Sums a lane each for the eight nodes of a column of eights, in the order of the spans.
struct Totals {
  const NodeRows& r;
  double light, dt;
  double power[eight] = {}, squares[eight] = {}, gained[eight] = {}, upward[eight] = {};

  template <class D>
  HWY_INLINE void at(std::size_t n, std::size_t lane) {
    const V<D> m = load<D>(r.m + n), ax = load<D>(r.a_x + n), ay = load<D>(r.a_y + n);
    const auto counts = m > all<D>(light);
    const V<D> back = hn::IfThenElse(counts, all<D>(0.5 * dt), all<D>(dt));
    const V<D> wx = load<D>(r.u_x + n) - back * ax, wy = load<D>(r.u_y + n) - back * ay;
    add_to<D>(power + lane, load<D>(r.force_x + n) * wx + load<D>(r.force_y + n) * wy);
    add_to<D>(squares + lane, hn::IfThenElseZero(counts, m * (ax * ax + ay * ay)));
    add_to<D>(gained + lane, m * (ax * wx + ay * wy));
    add_to<D>(upward + lane, m * wy);
  }
};

double sum_of(const double (&lanes)[eight]) {
  double sum = 0;
  for (const double lane : lanes) sum += lane;
  return sum;
}

LaneTotals total(const NodeRows& rows, const ActiveNodes& active, double light, double dt) {
  Totals totals{rows, light, dt};
  for (const NodeSpan span : active.spans()) {
    std::size_t n = span.begin, lane = 0;
    for (; n + width<All> <= span.end; n += width<All>, lane = (lane + width<All>) % eight) totals.at<All>(n, lane);
    for (; n < span.end; ++n, lane = (lane + 1) % eight) totals.at<One>(n, lane);
  }
  return {sum_of(totals.power), sum_of(totals.squares), sum_of(totals.gained), sum_of(totals.upward)};
}

NodePasses passes_at_nodes() { return {clear, map_velocity, divide_convected, solve, total}; }

}  // namespace tether::mpm::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace tether::mpm {

NodePasses node_passes(InstructionSet set) {
  switch (set) {
    case InstructionSet::avx512:
      return N_AVX3::passes_at_nodes();
    case InstructionSet::avx2:
      return N_AVX2::passes_at_nodes();
    case InstructionSet::sse2:
      return N_SSSE3::passes_at_nodes();
    case InstructionSet::one:
      break;
  }
  return N_SCALAR::passes_at_nodes();
}

}  // namespace tether::mpm

#endif
