// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <utility>

#include "base/numbers.hpp"
#include "deck/words.hpp"
#include "read/box/box.hpp"
#include "read/box/figures.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

using RegionShape = std::variant<Figure, Below, Where>;

std::optional<RegionShape> shape_of(const Deck& deck, AnyVariable name, int k, FigureReader& read,
                                    Diagnostics& diagnostics) {
  const auto of_figure = [](std::optional<Figure> figure) {
    return figure ? std::optional<RegionShape>(std::move(*figure)) : std::nullopt;
  };
  if (name == AnyVariable("coupled.liquid_box")) return of_figure(read.box("coupled.liquid_box", k));
  if (name == AnyVariable("coupled.liquid_ellipse")) return of_figure(read.ellipse("coupled.liquid_ellipse", k));
  if (name == AnyVariable("coupled.liquid_polygon")) return of_figure(read.polygon("coupled.liquid_polygon", k));
  if (name == AnyVariable("coupled.liquid_where")) {
    auto holds = expression_of(deck, "coupled.liquid_where", k, {"x", "y", "z"}, diagnostics);
    return holds ? std::optional<RegionShape>(Where{std::move(holds)}) : std::nullopt;
  }
  auto height = expression_of(deck, "coupled.liquid_below", k, {"x", "z"}, diagnostics);
  return height ? std::optional<RegionShape>(Below{std::move(height)}) : std::nullopt;
}

Vec<3> velocity_of(const Deck& deck, const Coupled& coupled, int k) {
  Vec<3> velocity = coupled.start;
  for (int i = 1; i <= 3; ++i) {
    if (deck.given("coupled.liquid_velocity", i, k)) velocity[at(i - 1)] = deck.real("coupled.liquid_velocity", i, k);
  }
  return velocity;
}

}  // namespace

void add_liquid(const Deck& deck, Coupled& coupled, Diagnostics& diagnostics) {
  if (!deck.logical("coupled.liquid")) return;
  Liquid liquid;
  FigureReader read(deck, coupled.grid, diagnostics);
  for (const auto& [k, name] :
       read.given("region of liquid", {"coupled.liquid_box", "coupled.liquid_ellipse", "coupled.liquid_polygon",
                                       "coupled.liquid_below", "coupled.liquid_where"})) {
    const auto shape = shape_of(deck, name, k, read, diagnostics);
    if (shape) liquid.regions.push_back({*shape, velocity_of(deck, coupled, k), k});
  }
  liquid.jitter = deck.real("coupled.liquid_jitter");
  liquid.air = word<Air>(deck, "coupled.air");
  liquid.per_axis = deck.given("coupled.liquid_particles") ? deck.integer("coupled.liquid_particles")
                    : coupled.grid.dim == 2                ? 3
                                                           : 2;
  coupled.liquid = std::move(liquid);
}

void add_shaped_obstacles(const Deck& deck, Coupled& coupled, Diagnostics& diagnostics) {
  FigureReader read(deck, coupled.grid, diagnostics);
  for (const auto& [k, name] : read.given("obstacle", {"coupled.obstacle", "coupled.obstacle_ellipse",
                                                       "coupled.obstacle_polygon", "coupled.obstacle_plane"})) {
    std::optional<Figure> figure;
    if (name == AnyVariable("coupled.obstacle_ellipse")) figure = read.ellipse("coupled.obstacle_ellipse", k);
    if (name == AnyVariable("coupled.obstacle_polygon")) figure = read.polygon("coupled.obstacle_polygon", k);
    if (name == AnyVariable("coupled.obstacle_plane")) figure = read.plane("coupled.obstacle_plane", k);
    if (figure) coupled.shaped.push_back({std::move(*figure), k});
  }
}

}  // namespace tether
