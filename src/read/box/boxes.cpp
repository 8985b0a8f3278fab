// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "read/box/coupled_of_deck.hpp"

namespace tether {
namespace {

/// What a box is made of: cells whose middles lie in it, or parts of cells, too.
enum class HeldBy { middles_of_cells, parts_of_cells };

/// Reads box k of obstacle, void or smoke_box, or reports why there is none.
std::optional<AxisBox> box_of(const Deck& deck, const char* name, int k, const StaggeredGrid& grid, HeldBy by,
                              Diagnostics& diagnostics) {
  const auto refuse = [&](int i, const std::string& message, const std::string& hint) {
    diagnostics.add(deck.remark(Severity::error, "coupled", name, {i, k}, message, hint));
    return std::nullopt;
  };
  AxisBox box;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const int first = 2 * axis + 1;
    box.low[i] = grid.low[i], box.high[i] = grid.high(axis);
    if (axis >= grid.dim) continue;
    for (const int end : {first, first + 1}) {
      if (!deck.given("coupled", name, end, k))
        return refuse(deck.given("coupled", name, first, k) ? first : 1,
                      fmt::format("{} {}: {}({},{}) is not given", name, k, name, end, k),
                      "a box has a lowest and a highest place along each axis");
    }
    const double low = deck.real("coupled", name, first, k), high = deck.real("coupled", name, first + 1, k);
    if (!(high > low))
      return refuse(first + 1, fmt::format("{} {}: {:.6g} is not above {:.6g}", name, k, high, low),
                    "the lowest place first, along x, y, z");
    if (high <= box.low[i] || low >= box.high[i])
      return refuse(first,
                    fmt::format("{} {} from {:.6g} to {:.6g} lies outside the box, {:.6g} to {:.6g} in {}", name, k,
                                low, high, box.low[i], box.high[i], "xyz"[i]),
                    "what reaches beyond the box is left away, but a part must lie in it");
    box.low[i] = low, box.high[i] = high;
    if (by == HeldBy::parts_of_cells) continue;
    const int next = static_cast<int>(std::ceil(std::max((low - grid.low[i]) / grid.d[i] - 0.5, 0.0)));  // middle
    if (next >= grid.n[i] || grid.middle(axis, next) > high)
      return refuse(first,
                    fmt::format("{} {} from {:.6g} to {:.6g} holds no cell: it is thinner than one in {}", name, k, low,
                                high, "xyz"[i]),
                    "it is made of the cells whose middles lie in it: widen it, or use more nodes");
  }
  return box;
}

/// Warns of a box whose edges are not at faces of the grid, with what its cells make of it.
void tell_rounding(const Deck& deck, const char* name, int k, const AxisBox& box, const StaggeredGrid& grid,
                   Diagnostics& diagnostics) {
  constexpr double rounding = 1e-3;  // of a cell
  const AxisBox got = cells_of(box, grid);
  double size = 1, size_got = 1;
  std::string places;
  bool off = false;
  for (int axis = 0; axis < grid.dim; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    off =
        off || std::max(std::abs(got.low[i] - box.low[i]), std::abs(got.high[i] - box.high[i])) > rounding * grid.d[i];
    size *= box.high[i] - box.low[i], size_got *= got.high[i] - got.low[i];
    places += fmt::format("{}{:.6g} to {:.6g} in {}", axis == 0 ? "" : ", ", got.low[i], got.high[i], "xyz"[i]);
  }
  if (!off) return;
  diagnostics.add(
      deck.remark(Severity::warning, "coupled", name, {1, k},
                  fmt::format("for the fluid {} {} is made of the cells from {}: {:.4g} in place of {:.4g}, {:+.2g} %",
                              name, k, places, size_got, size, 100 * (size_got / size - 1)),
                  "place its edges at faces of the grid, or use more nodes"));
}

std::vector<AxisBox> boxes_of(const Deck& deck, const char* name, const StaggeredGrid& grid, Diagnostics& diagnostics) {
  std::set<int> numbers;
  for (const Subscript at : deck.given_elements("coupled", name)) numbers.insert(at[1]);
  std::vector<AxisBox> boxes;
  for (const int k : numbers) {
    const auto box = box_of(deck, name, k, grid, HeldBy::middles_of_cells, diagnostics);
    if (!box) continue;
    tell_rounding(deck, name, k, *box, grid, diagnostics);
    boxes.push_back(*box);
  }
  return boxes;
}

void add_smoke_boxes(const Deck& deck, Coupled& coupled, Diagnostics& diagnostics) {
  std::set<int> numbers;
  for (const Subscript at : deck.given_elements("coupled", "smoke_box")) numbers.insert(at[1]);
  for (const char* name : {"box_smoke", "box_temperature"}) {
    for (const Subscript at : deck.given_elements("coupled", name)) {
      if (numbers.contains(at[0])) continue;
      diagnostics.add(deck.remark(Severity::error, "coupled", name, at,
                                  fmt::format("{}({}) is in no box: smoke_box(1,{}) is not given", name, at[0], at[0]),
                                  "smoke_box says where it is: lowest and highest x, y and, in space, z"));
    }
  }
  for (const int k : numbers) {
    const auto box = box_of(deck, "smoke_box", k, coupled.grid, HeldBy::parts_of_cells, diagnostics);
    if (!box) continue;
    const double density = deck.real("coupled", "box_smoke", k), warmth = deck.real("coupled", "box_temperature", k);
    if (density == 0 && warmth == 0)
      diagnostics.add(deck.remark(Severity::warning, "coupled", "smoke_box", {1, k},
                                  fmt::format("smoke_box {} holds neither smoke nor warmth", k),
                                  fmt::format("box_smoke({}) or box_temperature({}) says how much", k, k)));
    coupled.smoke_boxes.push_back({*box, density, warmth});
    coupled.smoke |= density != 0 || warmth != 0;
  }
}

}  // namespace

void add_boxes(const Deck& deck, Coupled& coupled, Diagnostics& diagnostics) {
  coupled.obstacles = boxes_of(deck, "obstacle", coupled.grid, diagnostics);
  coupled.voids = boxes_of(deck, "void", coupled.grid, diagnostics);
  add_smoke_boxes(deck, coupled, diagnostics);
}

}  // namespace tether
