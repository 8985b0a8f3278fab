// SPDX-License-Identifier: GPL-3.0-or-later
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "physics/points/lanes/nodes.cpp"
#include <hwy/foreach_target.h>
// After the line above, which reads this file again for each instruction set.
#include <hwy/highway.h>

#include "laws/walls.hpp"
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

/// Calls body.template at<Lanes>(n) for all nodes: by all lanes, and one by one what is left of a span.
template <class Body>
HWY_INLINE void each_node(std::span<const NodeSpan> nodes, const Body& body) {
  for (const NodeSpan span : nodes) {
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
void clear(std::span<double* const> rows, std::span<const NodeSpan> nodes) { each_node(nodes, Clear{rows}); }

/// Momenta over masses.
struct Divide {
  const double *m, *x, *y;
  double *u, *v;
  template <class D>
  HWY_INLINE void at(std::size_t n) const {
    const V<D> per_m = inverse_of<D>(load<D>(m + n));
    store<D>(per_m * load<D>(x + n), u + n), store<D>(per_m * load<D>(y + n), v + n);
  }
};
void map_velocity(const NodeRows& r, std::span<const NodeSpan> nodes) {
  each_node(nodes, Divide{r.m, r.momentum_x, r.momentum_y, r.convected_x, r.convected_y});
}

template <class D>
HWY_INLINE void clear_sums(const NodeRows& r, std::size_t n) {
  for (double* row : {r.m, r.momentum_x, r.momentum_y, r.force_x, r.force_y}) store<D>(hn::Zero(D()), row + n);
}

struct DivideAndClear {
  const NodeRows& r;
  template <class D>
  HWY_INLINE void at(std::size_t n) const {
    Divide{r.m, r.convected_x, r.convected_y, r.convected_x, r.convected_y}.at<D>(n);
    clear_sums<D>(r, n);
  }
};
void divide_convected(const NodeRows& r, std::span<const NodeSpan> nodes) { each_node(nodes, DivideAndClear{r}); }

/// The momentum equation, and its sums: a lane each for the eight nodes of a column of eights, in the order of spans.
struct Solve {
  const NodeRows& r;
  const NodeStep& step;
  double power[eight] = {}, squares[eight] = {}, gained[eight] = {}, upward[eight] = {};

  template <class D>
  HWY_INLINE void at(std::size_t n, std::size_t lane) {
    std::uint8_t walls = 0;
    for (std::size_t l = 0; l < width<D>; ++l) walls = static_cast<std::uint8_t>(walls | step.held[n + l]);
    if (HWY_LIKELY(walls == 0)) return solve<D>(n, lane, false, false);
    for (std::size_t l = 0; l < width<D>; ++l) {
      const bool x = (step.held[n + l] & holds_x) != 0, y = (step.held[n + l] & holds_y) != 0;
      solve<One>(n + l, (lane + l) % eight, x, y);
    }
  }

 private:
  template <class D>
  HWY_INLINE void solve(std::size_t n, std::size_t lane, bool holds_in_x, bool holds_in_y) {
    const V<D> zero = hn::Zero(D()), m = load<D>(r.m + n), per_m = inverse_of<D>(m), dt = all<D>(step.dt);
    const V<D> fx = load<D>(r.force_x + n), fy = load<D>(r.force_y + n);
    const V<D> ax = holds_in_x ? zero : fx * per_m, ay = holds_in_y ? zero : fy * per_m + all<D>(step.gravity);
    const V<D> ux = holds_in_x ? zero : load<D>(r.momentum_x + n) * per_m + dt * ax,
               uy = holds_in_y ? zero : load<D>(r.momentum_y + n) * per_m + dt * ay;
    store<D>(ax, r.a_x + n), store<D>(ay, r.a_y + n), store<D>(ux, r.u_x + n), store<D>(uy, r.u_y + n);
    const auto counts = m > all<D>(step.light);
    const V<D> back = hn::IfThenElse(counts, all<D>(0.5 * step.dt), dt);
    const V<D> wx = ux - back * ax, wy = uy - back * ay;
    add_to<D>(power + lane, fx * wx + fy * wy);
    add_to<D>(squares + lane, hn::IfThenElseZero(counts, m * (ax * ax + ay * ay)));
    add_to<D>(gained + lane, m * (ax * wx + ay * wy));
    add_to<D>(upward + lane, m * wy);
    if (step.clears) clear_sums<D>(r, n);
  }
};

double sum_of(const double (&lanes)[eight]) {
  double sum = 0;
  for (const double lane : lanes) sum += lane;
  return sum;
}

LaneTotals solve(const NodeRows& rows, std::span<const NodeSpan> nodes, const NodeStep& step) {
  Solve pass{rows, step};
  for (const NodeSpan span : nodes) {
    std::size_t n = span.begin, lane = 0;
    for (; n + width<All> <= span.end; n += width<All>, lane = (lane + width<All>) % eight) pass.at<All>(n, lane);
    for (; n < span.end; ++n, lane = (lane + 1) % eight) pass.at<One>(n, lane);
  }
  return {sum_of(pass.power), sum_of(pass.squares), sum_of(pass.gained), sum_of(pass.upward)};
}

NodePasses passes_at_nodes() { return {clear, map_velocity, divide_convected, solve}; }

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
#ifdef TETHER_SSE
      return N_SSSE3::passes_at_nodes();
#endif
    case InstructionSet::one:
      break;
  }
  return N_SCALAR::passes_at_nodes();
}

}  // namespace tether::mpm

#endif
