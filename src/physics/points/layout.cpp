// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/layout.hpp"

#include <algorithm>
#include <numeric>
#include <type_traits>
#include <utility>

#include "grid/kernels.hpp"
#include "loops/points.hpp"

namespace tether::mpm {
namespace {

/// Bodies with fewer points are done before lanes have begun.
constexpr std::size_t few = 64;

constexpr std::size_t nobody = Blocks::no_slot;

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

/// Slots of some points and their cells.
struct Placed {
  std::vector<std::size_t> slots;
  std::vector<Blocks::Cell> cells;
};

/// The points of a body by rows of cells, then by cells, in a cell by their numbers.
Placed in_order_of_cells(const State& state, Kernel kernel, Range range) {
  const auto nx = static_cast<std::size_t>(state.grid.frame.shape.nx);
  const auto number = [nx](Blocks::Cell cell) {
    return static_cast<std::size_t>(cell.row) * nx + static_cast<std::size_t>(cell.cell);
  };
  std::vector<std::size_t> end(state.grid.frame.shape.nodes() + 1);  // of each cell, in the points' order
  for_points(state.points, range, [&](std::size_t p) { ++end[number(cell_of(state, kernel, p)) + 1]; });
  std::partial_sum(end.begin(), end.end(), end.begin());
  Placed placed{std::vector<std::size_t>(end.back()), std::vector<Blocks::Cell>(end.back())};
  for_points(state.points, range, [&](std::size_t p) {
    const Blocks::Cell cell = cell_of(state, kernel, p);
    const std::size_t k = end[number(cell)]++;
    placed.slots[k] = p, placed.cells[k] = cell;
  });
  const auto& id = state.points.id;
  for (std::size_t n = 0, begin = 0; n + 1 < end.size(); begin = end[n++]) {
    std::sort(placed.slots.begin() + static_cast<std::ptrdiff_t>(begin),
              placed.slots.begin() + static_cast<std::ptrdiff_t>(end[n]),
              [&](std::size_t a, std::size_t b) { return id[a] < id[b]; });
  }
  return placed;
}

/// The body's blocks, and at the end of `from` the present slot of what comes into each of theirs.
void lay_out_body(const State& state, Kernel kernel, Range range, Blocks& blocks, std::vector<std::size_t>& from) {
  const Placed placed = in_order_of_cells(state, kernel, range);
  const std::vector<std::size_t> slots = blocks.lay_out(placed.cells);
  const std::size_t first = from.size();
  from.resize(first + blocks.capacity() * Blocks::lanes, nobody);
  for (std::size_t k = 0; k < slots.size(); ++k) from[first + slots[k]] = placed.slots[k];
}

template <class Number>
void permute(LineArray<Number>& array, const std::vector<std::size_t>& from) {
  LineArray<Number> permuted(from.size(), Number{});
  for (std::size_t k = 0; k < from.size(); ++k) {
    if (from[k] != nobody) permuted[k] = array[from[k]];
  }
  array.swap(permuted);
}

/// Where a slot without a point stands.
void stand_in_the_middle(State& state, const Blocks& blocks, std::size_t slot, Blocks::Cell cell) {
  const BackgroundGrid& shape = state.grid.frame.shape;
  state.points.x[slot] = shape.x0 + (cell.cell + blocks.middle()) * shape.dx;
  state.points.y[slot] = shape.y0 + (cell.row + blocks.middle()) * shape.dy;
}

/// The eight slots from `first` on that hold no point, in the middles of their cells.
void empty_block(State& state, const Blocks& blocks, std::size_t first, Blocks::Cell cell) {
  for (std::size_t l = 0; l < Blocks::lanes; ++l) {
    if (!state.points.holds(first + l))
      stand_in_the_middle(state, blocks, first + l, {cell.row, cell.cell + static_cast<int>(l)});
  }
}

/// Slots of the body that hold no point, in the middles of their cells.
void empty_slots(State& state, std::size_t b) {
  const Blocks& blocks = *state.blocks[b];
  const std::size_t first = state.ranges[b].begin;
  for (const Blocks::Group& group : blocks.groups()) {
    for (std::uint32_t block = group.first; block != Blocks::none; block = blocks.next(block)) {
      empty_block(state, blocks, first + block * Blocks::lanes, {group.row, group.cell});
    }
  }
}

}  // namespace

bool runs_by_lanes(const Scene& scene, std::size_t body) {
  const Body& of = scene.bodies[body];
  const Method& method = scene.method;
  if (of.count < few || scene.edges.any()) return false;
  const bool pins = std::any_of(scene.pinned.begin(), scene.pinned.end(),
                                [&](std::size_t p) { return p >= of.first && p < of.first + of.count; });
  if (pins) return false;
  if (std::holds_alternative<IdealGas>(of.material)) return true;
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

Movers::Movers(State& state, std::size_t body) : state_(state), body_(body) {
  Points& P = state.points;
  each_row(Points::rows(), [&](const auto& row) {
    auto& array = P.*row.array;
    if constexpr (std::is_same_v<decltype(array.data()), double*>) {
      if (row.carried_by(P)) arrays_.push_back(array.data());
    }
  });
}

void Movers::take(std::size_t slot, Blocks::Cell left, Blocks::Cell entered) {
  Points& P = state_.points;
  movers_.push_back({P.id[slot], P.pinned[slot], left, entered});
  for (double* array : arrays_) numbers_.push_back(array[slot]), array[slot] = 0;
  P.id[slot] = -1, P.pinned[slot] = 0;
  stand_in_the_middle(state_, *state_.blocks[body_], slot, left);
}

void Movers::put(std::size_t mover, std::size_t slot) {
  const double* number = numbers_.data() + mover * arrays_.size();
  for (double* array : arrays_) array[slot] = *number++;
  state_.points.id[slot] = movers_[mover].id, state_.points.pinned[slot] = movers_[mover].pinned;
}

void Movers::settle() {
  std::vector<std::size_t> left;
  for (std::size_t k = 0; k < movers_.size(); ++k) {
    const std::size_t slot = find_slot(movers_[k].entered);
    if (slot == Blocks::no_slot)
      left.push_back(k);
    else
      put(k, slot);
  }
  // There is no block any more for these: they stand anywhere until all are laid out anew.
  std::size_t slot = state_.ranges[body_].begin;
  for (const std::size_t k : left) {
    while (state_.points.holds(slot)) ++slot;
    put(k, slot);
  }
  for (const Mover& mover : movers_) close_ranks(mover.left);
  state_.blocks[body_]->settle();
}

/// Points that were left move up, so that the group needs no more blocks than its fullest cell.
void Movers::close_ranks(Blocks::Cell cell) {
  Points& P = state_.points;
  Blocks& blocks = *state_.blocks[body_];
  const std::size_t first = state_.ranges[body_].begin;
  const auto is_free = [&](std::size_t slot) { return !P.holds(first + slot); };
  for (auto gap = blocks.gap(cell, is_free); gap.is_there(); gap = blocks.gap(cell, is_free)) {
    const std::size_t from = first + gap.last, to = first + gap.free;
    for (double* array : arrays_) array[to] = std::exchange(array[from], 0);
    P.id[to] = std::exchange(P.id[from], -1), P.pinned[to] = std::exchange(P.pinned[from], std::uint8_t{0});
    stand_in_the_middle(state_, blocks, from, cell);
  }
  blocks.drop_empty(cell, is_free);
}

std::size_t Movers::find_slot(Blocks::Cell cell) {
  Blocks& blocks = *state_.blocks[body_];
  const std::size_t first = state_.ranges[body_].begin;
  const auto [slot, new_block] =
      blocks.find_free(cell, [&](std::size_t free) { return !state_.points.holds(first + free); });
  if (new_block && slot != Blocks::no_slot) {
    const int lane = cell.cell % static_cast<int>(Blocks::lanes);
    empty_block(state_, blocks, first + slot - static_cast<std::size_t>(lane), {cell.row, cell.cell - lane});
  }
  return slot == Blocks::no_slot ? slot : first + slot;
}

}  // namespace tether::mpm
