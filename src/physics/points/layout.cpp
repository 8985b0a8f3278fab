// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/layout.hpp"

#include <algorithm>
#include <numeric>

#include "grid/kernels.hpp"
#include "loops/points.hpp"

namespace tether::mpm {
namespace {

/// Bodies with fewer points are done before lanes have begun.
constexpr std::size_t few = 64;

constexpr std::size_t nobody = Blocks::no_slot;

/// A point of a body and its cell.
struct Placed {
  Blocks::Cell cell;
  int id;
  std::size_t slot;
};

bool before(const Placed& a, const Placed& b) {
  if (a.cell.row != b.cell.row) return a.cell.row < b.cell.row;
  return a.cell.cell != b.cell.cell ? a.cell.cell < b.cell.cell : a.id < b.id;
}

Blocks::Cell cell_of(const State& state, Kernel kernel, std::size_t p) {
  const Locator locator(state.grid.frame.shape);
  const double x = state.points.x[p], y = state.points.y[p];
  if (kernel == Kernel::bspline) {
    const auto at = SplineKernel::locate(locator, x, y);
    return {at.j, at.i};
  }
  const auto at = LinearKernel::locate(locator, x, y);
  return {at.j, at.i};
}

/// The body's blocks, and at the end of `from` the present slot of what comes into each of theirs.
void lay_out_body(const State& state, Kernel kernel, Range range, Blocks& blocks, std::vector<std::size_t>& from) {
  std::vector<Placed> placed;
  for_points(state.points, range, [&](std::size_t p) {
    placed.push_back({cell_of(state, kernel, p), state.points.id[p], p});
  });
  std::sort(placed.begin(), placed.end(), before);
  std::vector<Blocks::Cell> cells;
  for (const Placed& point : placed) cells.push_back(point.cell);
  const std::vector<std::size_t> slots = blocks.lay_out(cells);
  const std::size_t first = from.size();
  from.resize(first + blocks.capacity() * Blocks::lanes, nobody);
  for (std::size_t k = 0; k < placed.size(); ++k) from[first + slots[k]] = placed[k].slot;
}

template <class Number>
void permute(std::vector<Number>& array, const std::vector<std::size_t>& from) {
  std::vector<Number> permuted(from.size(), Number{});
  for (std::size_t k = 0; k < from.size(); ++k) {
    if (from[k] != nobody) permuted[k] = array[from[k]];
  }
  array.swap(permuted);
}

/// The eight slots from `first` on that hold no point, in the middles of their cells.
void empty_block(State& state, std::size_t first, Blocks::Cell cell) {
  for (std::size_t l = 0; l < Blocks::lanes; ++l) {
    if (!state.points.holds(first + l)) make_empty(state, first + l, {cell.row, cell.cell + static_cast<int>(l)});
  }
}

/// Slots of the body that hold no point, in the middles of their cells.
void empty_slots(State& state, std::size_t b) {
  const Blocks& blocks = *state.blocks[b];
  const std::size_t first = state.ranges[b].begin;
  for (const Blocks::Group& group : blocks.groups()) {
    for (std::uint32_t block = group.first; block != Blocks::none; block = blocks.next(block)) {
      empty_block(state, first + block * Blocks::lanes, {group.row, group.cell});
    }
  }
}

}  // namespace

bool runs_by_lanes(const Scene& scene, std::size_t body) {
  const Body& of = scene.bodies[body];
  const Method& method = scene.method;
  if (of.count < few || scene.edges.any() || scene.geometry != Geometry::plane) return false;
  if (method.order != StressOrder::usf || method.transfer != Transfer::apic || method.kernel != Kernel::bspline)
    return false;
  if (method.contact != ContactRule::none && scene.bodies.size() > 1 && has_solid(scene)) return false;
  const bool pins = std::any_of(scene.pinned.begin(), scene.pinned.end(),
                                [&](std::size_t p) { return p >= of.first && p < of.first + of.count; });
  if (pins) return false;
  if (const auto* gas = std::get_if<IdealGas>(&of.material)) return gas->rule == DensityRule::grid;
  return std::holds_alternative<PlaneElastic>(of.material) && !method.jaumann;
}

void lay_out(State& state, const Scene& scene) {
  std::vector<std::size_t> from;
  std::vector<Range> ranges(state.ranges.size());
  std::size_t points = 0;
  for (const bool lanes : {false, true}) {
    for (std::size_t b = 0; b < ranges.size(); ++b) {
      if (state.blocks[b].has_value() != lanes) continue;
      from.resize((from.size() + Blocks::lanes - 1) / Blocks::lanes * Blocks::lanes, nobody);
      ranges[b].begin = from.size();
      if (lanes) {
        lay_out_body(state, scene.method.kernel, state.ranges[b], *state.blocks[b], from);
      } else {
        for_points(state.points, state.ranges[b], [&](std::size_t p) { from.push_back(p); });
      }
      ranges[b].end = from.size();
    }
  }
  for (const std::size_t slot : from) points += slot != nobody;
  each_row(Points::rows(), [&](const auto& row) {
    if (row.carried_by(state.points)) permute(state.points.*row.array, from);
  });
  for (std::size_t k = 0; k < from.size(); ++k) {
    if (from[k] == nobody) state.points.id[k] = -1;
  }
  state.empty_slots = from.size() - points;
  state.ranges = std::move(ranges);
  for (std::size_t b = 0; b < state.ranges.size(); ++b) {
    if (state.blocks[b]) empty_slots(state, b);
  }
}

void move_point(State& state, std::size_t from, std::size_t to, Blocks::Cell cell) {
  each_row(Points::rows(), [&](const auto& row) {
    auto& array = state.points.*row.array;
    if (row.remembered() && row.carried_by(state.points)) array[to] = array[from];
  });
  make_empty(state, from, cell);
}

std::size_t find_slot(State& state, std::size_t b, Blocks::Cell cell) {
  Blocks& blocks = *state.blocks[b];
  const std::size_t first = state.ranges[b].begin, before = blocks.blocks();
  const std::size_t slot = blocks.find_free(cell, [&](std::size_t free) { return !state.points.holds(first + free); });
  if (blocks.blocks() > before) {
    const int lane = cell.cell % static_cast<int>(Blocks::lanes);
    empty_block(state, first + slot - static_cast<std::size_t>(lane), {cell.row, cell.cell - lane});
  }
  return slot == Blocks::no_slot ? slot : first + slot;
}

void make_empty(State& state, std::size_t slot, Blocks::Cell cell) {
  Points& P = state.points;
  each_row(Points::rows(), [&](const auto& row) {
    if (row.carried_by(P)) (P.*row.array)[slot] = {};
  });
  P.id[slot] = -1;
  const BackgroundGrid& shape = state.grid.frame.shape;
  P.x[slot] = shape.x0 + cell.cell * shape.dx, P.y[slot] = shape.y0 + cell.row * shape.dy;
}

}  // namespace tether::mpm
