// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/layout.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "grid/kernels.hpp"
#include "loops/points.hpp"

namespace tether::mpm {
namespace {

/// Bodies with fewer points are done before lanes have begun.
constexpr std::size_t few = 64;

/// Where no point comes into a slot.
constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();

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

/// Calls visit(cell, slot, points) for the cells that hold points, with the slot of the first of so many.
template <class Visit>
void each_cell(const Blocks& blocks, const Visit& visit) {
  for (const Blocks::Group& group : blocks.groups()) {
    for (std::size_t l = 0; l < Blocks::lanes; ++l) {
      const Blocks::Cell cell{group.row, group.cell + static_cast<int>(l)};
      if (group.points[l] > 0) visit(cell, group.first * Blocks::lanes + l, group.points[l]);
    }
  }
}

/// Sorts the points of a cell by their numbers; they stand in `from` a block apart.
void sort_cell(const LineArray<int>& id, std::span<std::uint32_t> from, std::vector<std::uint32_t>& cell) {
  cell.clear();
  for (std::size_t k = 0; k < from.size(); k += Blocks::lanes) cell.push_back(from[k]);
  std::sort(cell.begin(), cell.end(), [&](std::uint32_t a, std::uint32_t b) { return id[a] < id[b]; });
  for (std::size_t k = 0; k < cell.size(); ++k) from[k * Blocks::lanes] = cell[k];
}

/// The body's blocks, and at the end of `from` the present slot of what comes into each of theirs.
void lay_out_body(const State& state, Kernel kernel, Slots range, Blocks& blocks, std::vector<std::uint32_t>& from) {
  const auto number = [nx = blocks.cells_x()](Blocks::Cell cell) {
    return static_cast<std::size_t>(cell.row) * nx + static_cast<std::size_t>(cell.cell);
  };
  std::vector<std::uint32_t> points_in(blocks.cells_x() * blocks.cells_y());
  for_points(state.points, range, [&](std::size_t p) { ++points_in[number(cell_of(state, kernel, p))]; });
  blocks.lay_out(points_in);
  const std::size_t first = from.size();
  from.resize(first + slots_for(blocks.blocks()), nobody);
  std::vector<std::size_t> next(points_in.size());  // slot of each cell's next point
  std::vector<std::uint32_t> cell;
  each_cell(blocks, [&](Blocks::Cell at, std::size_t slot, std::size_t) { next[number(at)] = first + slot; });
  for_points(state.points, range, [&](std::size_t p) {
    std::size_t& slot = next[number(cell_of(state, kernel, p))];
    from[slot] = static_cast<std::uint32_t>(p), slot += Blocks::lanes;
  });
  each_cell(blocks, [&](Blocks::Cell, std::size_t slot, std::size_t points) {
    if (points > 1)
      sort_cell(state.points.id, std::span(from).subspan(first + slot, (points - 1) * Blocks::lanes + 1), cell);
  });
}

template <class Number>
void permute(LineArray<Number>& array, const std::vector<std::uint32_t>& from) {
  LineArray<Number> permuted(from.size(), Number{});
  for (std::size_t k = 0; k < from.size(); ++k) {
    if (from[k] != nobody) permuted[k] = array[from[k]];
  }
  array.swap(permuted);
}

/// Slots of the body that hold no point, in the middles of their cells.
void empty_slots(State& state, std::size_t b) {
  const Blocks& blocks = *state.blocks[b];
  for (const Blocks::Group& group : blocks.groups()) {
    for (std::uint32_t block = group.first; block != Blocks::none; block = blocks.next(block))
      empty_block(state, b, block, {group.row, group.cell});
  }
}

}  // namespace

bool runs_by_lanes(const Scene& scene, std::size_t body) {
  const Body& of = scene.bodies[body];
  if (of.count < few || scene.edges.any()) return false;
  const bool pins = std::any_of(scene.pinned.begin(), scene.pinned.end(),
                                [&](std::size_t p) { return p >= of.first && p < of.first + of.count; });
  return !pins && !std::holds_alternative<Membrane>(of.material);
}

void lay_out(State& state, const Scene& scene) {
  std::vector<std::uint32_t> from;
  std::vector<Slots> ranges(state.ranges.size());
  std::size_t points = 0;
  for (const bool lanes : {false, true}) {
    for (std::size_t b = 0; b < ranges.size(); ++b) {
      if (state.blocks[b].has_value() != lanes) continue;
      from.resize((from.size() + Blocks::lanes - 1) / Blocks::lanes * Blocks::lanes, nobody);
      ranges[b].begin = from.size(), ranges[b].gaps = lanes;
      if (lanes) {
        lay_out_body(state, scene.method.kernel, state.ranges[b], *state.blocks[b], from);
      } else {
        for_points(state.ranges[b].full(), [&](std::size_t p) { from.push_back(static_cast<std::uint32_t>(p)); });
      }
      ranges[b].end = from.size();
    }
  }
  for (const std::uint32_t slot : from) points += slot != nobody;
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

std::size_t slots_for(std::size_t blocks) { return (blocks + blocks / 16 + 16) * Blocks::lanes; }

void empty_block(State& state, std::size_t body, std::size_t block, Blocks::Cell cell) {
  const std::size_t first = state.ranges[body].begin + block * Blocks::lanes;
  for (std::size_t l = 0; l < Blocks::lanes; ++l) {
    if (!state.points.holds(first + l))
      stand_in_the_middle(state, body, first + l, {cell.row, cell.cell + static_cast<int>(l)});
  }
}

void stand_in_the_middle(State& state, std::size_t body, std::size_t slot, Blocks::Cell cell) {
  const BackgroundGrid& shape = state.grid.frame.shape;
  const double middle = state.blocks[body]->middle();
  state.points.x[slot] = shape.x0 + (cell.cell + middle) * shape.dx;
  state.points.y[slot] = shape.y0 + (cell.row + middle) * shape.dy;
}

}  // namespace tether::mpm
