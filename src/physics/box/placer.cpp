// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/placer.hpp"

#include <algorithm>
#include <utility>

#include "physics/box/pressure_sampler.hpp"

namespace tether::coupled {

Room Placer::room_at(std::span<const double> q) const {
  const bool cut = scene_.coupling.cuts_faces;
  Room room;
  room.places = whole_.places(q);
  room.pieces = cut_surface(surface_, q, scene_.grid, cut || scene_.liquid ? 2 : 1);
  if (whole_.has_obstacles()) whole_.add_obstacles(room.all = room.pieces);
  room.crossings = find_crossings(whole_.surface(), room.places, scene_.grid);
  room.domain = box_.around(room.crossings);
  if (cut) {
    room.cells = cut_cells(room.all_pieces(), room.crossings, room.domain);
    room.domain = box_.around(room.crossings, room.cells);
  }
  if (scene_.liquid) room.open = liquid::open_parts(room.domain, room.all_pieces());
  return room;
}

Placement Placer::in(Room room, std::span<const double> q, std::span<const double> filled) const {
  Placement at;
  if (filled.empty()) {
    at.domain = std::move(room.domain);
  } else {
    std::vector<double> distance = liquid::surface_distances(scene_.grid, filled, room.open);
    at.surface = {std::move(room.domain), std::move(room.open), std::move(distance)};
    at.domain = liquid::liquid_in(at.surface->room, at.surface->distance, scene_.liquid->air);
  }
  map(q, room, at);
  const std::vector<std::uint8_t> pockets = find_pockets(at.domain, at.map);
  if (std::find(pockets.begin(), pockets.end(), 1) != pockets.end()) {
    drop_regions(pockets, at.domain);
    map(q, room, at);
  }
  if (scene_.viscosity > 0) at.near_faces = surface_near_faces(whole_.surface(), room.places, scene_.grid);
  at.pieces = std::move(room.pieces.pieces), at.thin = std::move(room.cells.thin);
  return at;
}

Placement Placer::at(std::span<const double> q, std::span<const double> filled) const {
  return in(room_at(q), q, filled);
}

void Placer::map(std::span<const double> q, const Room& room, Placement& at) const {
  const CutCells* cut = scene_.coupling.cuts_faces ? &room.cells : nullptr;
  at.numbers = number_pressures(at.domain);
  const PressureSampler sampler(surface_, q, room.pieces, at.domain);
  const CoupledSurface of{surface_, room.pieces, at.domain, at.numbers, &outside_};
  at.map = map_by_pressures(team_, of, sampler, cut);
  if (scene_.coupling.two_maps) at.crossing_map = map_by_crossings(team_, of, room.crossings, q.size());
}

}  // namespace tether::coupled
