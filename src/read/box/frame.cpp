// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "base/vec.hpp"
#include "read/box/box.hpp"
#include "read/box/checks.hpp"
#include "read/box/figures.hpp"
#include "read/limits.hpp"
#include "read/points/geometry.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

/// Reports what a scene cannot be made of.
class Frame {
 public:
  Frame(const Deck& deck, Diagnostics& diagnostics)
      : deck_(deck), diagnostics_(diagnostics), space_(deck.given("coupled.nz")) {}

  bool check() {
    groups();
    depth();
    cells();
    if (deck_.has_group("mesh")) mesh();
    if (good_) memory();
    return good_;
  }

 private:
  void no_group(const char* group, const std::string& message, const std::string& hint) {
    diagnostics_.add(deck_.remark_on_group(Severity::error, group, message, hint));
    good_ = false;
  }
  void no(AnyVariable name, Subscript at, const std::string& message, const std::string& hint) {
    diagnostics_.add(deck_.remark(Severity::error, name, at, message, hint));
    good_ = false;
  }
  void groups() {
    if (deck_.has_group("flow")) {
      no_group("flow", "$flow stands beside $coupled", "a deck has one fluid: by $flow on a mesh, or in the box");
    } else if (has_flow(deck_)) {
      no("fem.law", {regions_of(deck_, true)[0], 1}, "a region of $reg is a fluid beside $coupled",
         "$coupled describes the fluid, regions are solids");
    }
    if (deck_.has_group("rigid"))
      no_group("rigid", "rigid bodies in a fluid are not modelled", "leave $rigid away: elastic bodies are");
    if (geometry_of(deck_) == Geometry::axisymmetric)
      no("in.cyl", {1, 1}, "a fluid in a box has no axis", "write cyl=0.");
  }
  void depth() {
    for (const AnyVariable end : Variables{"coupled.zback", "coupled.zfront"}) {
      if (deck_.given(end) == space_) continue;
      const AnyVariable nz = "coupled.nz", there = space_ ? nz : end;
      no(there, {1, 1}, fmt::format("{} is not given, but {} is", space_ ? end : nz, there),
         "a box in space has nz, zback and zfront; in the plane leave them away");
      return;
    }
    if (!space_) return;
    const double low = deck_.real("coupled.zback"), high = deck_.real("coupled.zfront");
    const double size = (high - low) / (deck_.integer("coupled.nz") - 1);
    if (high > low && std::isfinite(size) && std::isfinite(1 / size) && low + size > low && high - size < high) return;
    no("coupled.zfront", {1, 1}, fmt::format("zfront = {:.6g} is not above zback = {:.6g}", high, low),
       "the nodes would coincide");
  }
  void cells() {
    const auto few = [&](AnyVariable name) {
      if (deck_.integer(name) < 3)
        no(name, {1, 1}, "the box has fewer than 2 cells along an axis",
           fmt::format("{} counts nodes: write 3 or more", name));
    };
    few("in.nx"), few("in.ny");
    if (space_) few("coupled.nz");
  }
  void memory() {
    StaggeredGrid grid;
    grid.n = {deck_.integer("in.nx") - 1, deck_.integer("in.ny") - 1, space_ ? deck_.integer("coupled.nz") - 1 : 1};
    const std::string too_large = memory_refusal(grid);
    if (!too_large.empty()) no(space_ ? AnyVariable("coupled.nz") : "in.nx", {1, 1}, too_large, "use fewer nodes");
  }
  void mesh() {
    const auto z = deck_.given_elements("mesh.z");
    if (deck_.text("mesh.file").empty()) {
      if (!space_ && !z.empty())
        no("mesh.z", z[0], "the mesh is three-dimensional, but the box is plane",
           "give nz, zback and zfront of $coupled, or leave z away");
      if (space_ && z.empty())
        no("coupled.nz", {1, 1}, "the box is three-dimensional, but the mesh is plane",
           "give z of the regions in $mesh, or leave nz, zback and zfront away");
    }
  }

  const Deck& deck_;
  Diagnostics& diagnostics_;
  bool space_, good_ = true;
};

}  // namespace

bool check_coupled_frame(const Deck& deck, Diagnostics& diagnostics) { return Frame(deck, diagnostics).check(); }

namespace {

/// What a box is made of: cells whose middles lie in it, or parts of cells, too.
enum class HeldBy { middles_of_cells, parts_of_cells };

/// Reads box k of obstacle, void or smoke_box, or reports why there is none.
std::optional<Box<3>> box_of(const Deck& deck, RealVariable name, int k, const StaggeredGrid& grid, HeldBy by,
                             Diagnostics& diagnostics) {
  const auto box = FigureReader(deck, grid, diagnostics).box(name, k);
  for (int axis = 0; box && by == HeldBy::middles_of_cells && axis < grid.dim; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const double low = box->low[i], high = box->high[i];
    const int next = static_cast<int>(std::ceil(std::max((low - grid.low[i]) / grid.d[i] - 0.5, 0.0)));  // middle
    if (next < grid.n[i] && grid.middle(axis, next) <= high) continue;
    diagnostics.add(deck.remark(Severity::error, name, {2 * axis + 1, k},
                                fmt::format("{} {} from {:.6g} to {:.6g} holds no cell: it is thinner than one in {}",
                                            name, k, low, high, "xyz"[i]),
                                "it is made of the cells whose middles lie in it: widen it, or use more nodes"));
    return std::nullopt;
  }
  return box;
}

/// Warns of a box whose edges are not at faces of the grid, with what its cells make of it.
void tell_rounding(const Deck& deck, AnyVariable name, int k, const Box<3>& box, const StaggeredGrid& grid,
                   Diagnostics& diagnostics) {
  constexpr double rounding = 1e-3;  // of a cell
  const Box<3> got = cells_of(box, grid);
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
      deck.remark(Severity::warning, name, {1, k},
                  fmt::format("for the fluid {} {} is made of the cells from {}: {:.4g} in place of {:.4g}, {:+.2g} %",
                              name, k, places, size_got, size, 100 * (size_got / size - 1)),
                  "place its edges at faces of the grid, or use more nodes"));
}

/// Reads boxes that cells make; on a mesh of the fluid they are as the deck has them.
std::vector<Box<3>> boxes_of(const Deck& deck, RealVariable name, const Coupled& coupled, Diagnostics& diagnostics) {
  const StaggeredGrid& grid = coupled.grid;
  const bool by_cells = !coupled.mesh;
  std::set<int> numbers;
  for (const Subscript at : deck.given_elements(name)) numbers.insert(at[1]);
  std::vector<Box<3>> boxes;
  for (const int k : numbers) {
    const auto box =
        box_of(deck, name, k, grid, by_cells ? HeldBy::middles_of_cells : HeldBy::parts_of_cells, diagnostics);
    if (!box) continue;
    if (by_cells) tell_rounding(deck, name, k, *box, grid, diagnostics);
    boxes.push_back(*box);
  }
  return boxes;
}

void add_smoke_boxes(const Deck& deck, Coupled& coupled, Diagnostics& diagnostics) {
  std::set<int> numbers;
  for (const Subscript at : deck.given_elements("coupled.smoke_box")) numbers.insert(at[1]);
  for (const AnyVariable name : Variables{"coupled.box_smoke", "coupled.box_temperature"}) {
    for (const Subscript at : deck.given_elements(name)) {
      if (numbers.contains(at[0])) continue;
      diagnostics.add(deck.remark(Severity::error, name, at,
                                  fmt::format("{}({}) is in no box: smoke_box(1,{}) is not given", name, at[0], at[0]),
                                  "smoke_box says where it is: lowest and highest x, y and, in space, z"));
    }
  }
  for (const int k : numbers) {
    const auto box = box_of(deck, "coupled.smoke_box", k, coupled.grid, HeldBy::parts_of_cells, diagnostics);
    if (!box) continue;
    const double density = deck.real("coupled.box_smoke", k), warmth = deck.real("coupled.box_temperature", k);
    if (density == 0 && warmth == 0)
      diagnostics.add(deck.remark(Severity::warning, "coupled.smoke_box", {1, k},
                                  fmt::format("smoke_box {} holds neither smoke nor warmth", k),
                                  fmt::format("box_smoke({}) or box_temperature({}) says how much", k, k)));
    coupled.smoke_boxes.push_back({*box, density, warmth});
    coupled.smoke |= density != 0 || warmth != 0;
  }
}

}  // namespace

void add_boxes(const Deck& deck, Coupled& coupled, Diagnostics& diagnostics) {
  coupled.obstacles = boxes_of(deck, "coupled.obstacle", coupled, diagnostics);
  coupled.voids = boxes_of(deck, "coupled.void", coupled, diagnostics);
  add_smoke_boxes(deck, coupled, diagnostics);
}

}  // namespace tether
