// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/vec.hpp"
#include "grid/mesh_flaws.hpp"
#include "grid/mesh_place.hpp"
#include "model/coupled.hpp"
#include "model/solids.hpp"
#include "read/box/checks.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

/// A node's place; in the plane with the middle of the grid's layer of cells as z.
Vec<3> place_of(const Mesh& mesh, int node) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  Vec<3> place{0, 0, 0.5};
  std::copy_n(&mesh.x[static_cast<std::size_t>(node) * dim], dim, place.begin());
  return place;
}

/// Returns whether a place lies in a box by more than a part of the box's size; a negative part: within it or so near
/// to it.
bool deep_in(const Box<3>& box, const Vec<3>& place, double part) {
  for (std::size_t i = 0; i < 3; ++i) {
    const double depth = part * (box.high[i] - box.low[i]);
    if (place[i] <= box.low[i] + depth || place[i] >= box.high[i] - depth) return false;
  }
  return true;
}

/// Says where a node of a body cannot be, or nothing.
const char* wrong_place(const Coupled& coupled, const Box<3>& box, const Vec<3>& place) {
  constexpr double rounding = 1e-9;
  if (!deep_in(box, place, -rounding)) return "outside the box";
  const bool blocked = std::any_of(coupled.obstacles.begin(), coupled.obstacles.end(),
                                   [&](const Box<3>& obstacle) { return deep_in(obstacle, place, rounding); }) ||
                       std::any_of(coupled.shaped.begin(), coupled.shaped.end(),
                                   [&](const Obstacle& obstacle) { return contains(obstacle.figure, place); });
  return blocked ? "in an obstacle" : nullptr;
}

void check_bodies(const Deck& deck, const Mesh& mesh, const Coupled& coupled, Diagnostics& diagnostics) {
  const std::vector<int> regions = regions_of(deck, false);
  const Box<3> box = coupled.grid.box();
  std::set<int> told;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (int a = 0; a < node_count_of(mesh.kind); ++a) {
      const int node = mesh.element(e)[a];
      const char* wrong = wrong_place(coupled, box, place_of(mesh, node));
      if (!wrong || !told.insert(mesh.region[e]).second) continue;
      const int r = regions[static_cast<std::size_t>(mesh.region[e])];
      diagnostics.add(
          deck.remark(Severity::error, "reg.xvi", {1, r},
                      fmt::format("region {}: its node {} at {} lies {}", r, node + 1, place_text(mesh, node), wrong),
                      "bodies start in the box of $in and zback to zfront of $coupled, beside its obstacles"));
    }
  }
}

/// Returns for each face of a jet the middle of what the jet has of it, and a place half a cell before that.
std::vector<Vec<3>> places_of(const Jet& jet, const StaggeredGrid& grid) {
  const auto across = static_cast<std::size_t>(axis_of_side(jet.side));
  std::vector<Vec<3>> places;
  for (const FacePart& of_jet : faces_of(jet.side, jet.patch, grid)) {
    const auto cell = grid.place_of_cell(cell_at(jet.side, grid, of_jet.face));
    Vec<3> place{};
    for (std::size_t i = 0; i < 3; ++i) {
      const double low = grid.low[i] + cell[i] * grid.d[i];
      place[i] = 0.5 * (std::max(low, jet.patch.low[i]) + std::min(low + grid.d[i], jet.patch.high[i]));
    }
    place[across] = grid.middle(static_cast<int>(across), cell[across]);
    places.push_back(place);
    place[across] = jet.patch.low[across];
    places.push_back(place);
  }
  return places;
}

/// The area of a jet whose cells belong to an obstacle.
double area_before_obstacles(const Jet& jet, const Coupled& coupled) {
  const StaggeredGrid& grid = coupled.grid;
  double area = 0;
  for (const FacePart& of_jet : faces_of(jet.side, jet.patch, grid)) {
    const auto cell = grid.place_of_cell(cell_at(jet.side, grid, of_jet.face));
    const Vec<3> middle{grid.middle(0, cell[0]), grid.middle(1, cell[1]), grid.middle(2, cell[2])};
    const auto holds = [&](const Box<3>& obstacle) { return obstacle.contains(middle); };
    if (std::any_of(coupled.obstacles.begin(), coupled.obstacles.end(), holds))
      area += of_jet.part * grid.area(axis_of_side(jet.side));
  }
  return area;
}

/// The element that has one of these places, or none.
std::optional<std::size_t> element_at(const Mesh& mesh, const std::vector<Vec<3>>& places) {
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    Vec<3> low = place_of(mesh, mesh.element(e)[0]), high = low;
    for (int a = 1; a < node_count_of(mesh.kind); ++a) {
      const Vec<3> node = place_of(mesh, mesh.element(e)[a]);
      for (std::size_t i = 0; i < 3; ++i) low[i] = std::min(low[i], node[i]), high[i] = std::max(high[i], node[i]);
    }
    const Box<3> about{low, high};
    if (std::any_of(places.begin(), places.end(),
                    [&](const Vec<3>& place) { return about.contains(place) && is_in_element(mesh, e, place); }))
      return e;
  }
  return std::nullopt;
}

void check_jet(const Deck& deck, const Jet& jet, const Mesh* mesh, const Coupled& coupled, Diagnostics& diagnostics) {
  const auto refuse = [&](const std::string& message, const std::string& hint) {
    diagnostics.add(deck.remark(Severity::error, "coupled.jet_on", {jet.number, 1}, message, hint));
  };
  const std::vector<Vec<3>> places = places_of(jet, coupled.grid);
  if (std::any_of(places.begin(), places.end(), [&](const Vec<3>& place) { return in_obstacle(coupled, place); }))
    return refuse(fmt::format("jet {} comes in through an obstacle", jet.number),
                  "a jet comes in where the cell behind the side holds fluid");
  const double lost = area_before_obstacles(jet, coupled);
  if (lost > 0)
    diagnostics.add(
        deck.remark(Severity::warning, "coupled.jet_on", {jet.number, 1},
                    fmt::format("jet {} loses an area of {:.4g} to cells that belong to an obstacle", jet.number, lost),
                    "place the obstacle's edge at faces of the grid"));
  const auto element = mesh ? element_at(*mesh, places) : std::nullopt;
  if (element)
    refuse(fmt::format("jet {} comes in through a body: through element {} at {}", jet.number, *element + 1,
                       place_text(*mesh, mesh->element(*element)[0])),
           "at the start a jet comes in where the cell behind the side holds fluid");
}

}  // namespace

void check_coupled_places(const Deck& deck, const Scene& scene, const Coupled& coupled, Diagnostics& diagnostics) {
  const Mesh* mesh = scene.solids() ? &scene.solids()->mesh : nullptr;
  if (mesh) check_bodies(deck, *mesh, coupled, diagnostics);
  for (const Jet& jet : coupled.jets) check_jet(deck, jet, mesh, coupled, diagnostics);
}

}  // namespace tether
