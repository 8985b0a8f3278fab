// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "physics/box/outside.hpp"
#include "physics/box/pressure_sampler.hpp"
#include "physics/box/side_matrix.hpp"

namespace tether::coupled {

/// Numbers of the pressures: of each cell, from 0; -1 without one.
struct PressureNumbers {
  std::vector<int> of_cell;
  std::vector<std::size_t> cell;  ///< of each pressure
};
PressureNumbers number_pressures(const FlowDomain& domain);
/// Returns the values of the pressures' cells, of values of all cells.
template <class Value>
std::vector<Value> of_cells(const PressureNumbers& numbers, const std::vector<Value>& values) {
  std::vector<Value> p;
  for (const std::size_t cell : numbers.cell) p.push_back(values[cell]);
  return p;
}

/// All that flow and solids know of each other: B u is the flux out of the fluid's cells that velocities u of the
/// solids' nodes cause, positive where a surface recedes [volume/time], and B^T p the pressure's force on them [force].
/// Each facet has a part in both by its area times its normal: turn() gives the map those of other places, and leaves
/// to each place of the surface the pressures that it has.
struct CouplingMap {
  static constexpr int outside_row = 0, film_weight_row = 1;  ///< of forces that are given

  CouplingMatrix B;
  /// Of each sheet of the surface the area that each region of the fluid sees: region r of sheet s at s regions + r.
  std::vector<double> area_seen;
  /// What the fluid beyond open sides does to the solids, in addition to B^T p: to what of them is beyond, and where
  /// pressures between the last cells and an open side, or in a film that ends beyond it, are its own in part [force].
  std::vector<double> outside;
  /// What the weight of the fluid in films does to the solids, in addition to B^T p, which has the pressures of their
  /// rims at the heights of these: in a film at rest it grows downwards [force].
  std::vector<double> film_weight;
  SideMatrix fluxes;  ///< B by areas
  SideMatrix given;   ///< outside and film_weight by areas, each in a row

  void turn(Team& team, std::span<const Vec<3>> area);
};

/// The sums that a map is made of, by the areas of facets: W of B, and of the forces that are given, a row each.
struct MapSums {
  std::vector<SideEntries> fluxes, given;
};
/// A map of so many pressures and numbers of the nodes' places, with the areas that facets have with the nodes at q; it
/// lacks the areas that are seen.
CouplingMap map_of_sums(Team& team, const SolidSurface& surface, EntriesAt where, MapSums sums, std::size_t pressures,
                        std::span<const double> q);

/// What a map is made from: the surface where it is now, and the fluid about it.
struct CoupledSurface {
  const SolidSurface& surface;
  const SurfacePieces& pieces;
  const FlowDomain& domain;
  const PressureNumbers& numbers;
  const Outside* outside = nullptr;  ///< null: of no pressure
};

/// Makes the map from pressures at the surface's points: B is the transpose of the paper's J. Where no cell is before
/// the surface it has the pressure of the film there. With `cut`, where neither cell is thin, pressures
/// are linear along each axis between the middles of the cells on both sides of the point.
CouplingMap map_by_pressures(Team& team, const CoupledSurface& at, const PressureSampler& sampler, const CutCells* cut);

/// Makes the map from the lines between cells' middles: the flux through a closed face is that of the solid where the
/// line meets it. It is the paper's D1 H, with the sign of B.
CouplingMatrix map_by_crossings(Team& team, const CoupledSurface& at, const Crossings& crossings, std::size_t unknowns);

}  // namespace tether::coupled
