// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "physics/box/coupling_map.hpp"

namespace tether::coupled {

/// The parts of a fluid that nothing joins, from 0.
struct FlowRegions {
  std::vector<int> of;  ///< each pressure's
  int count = 0;
  std::vector<std::uint8_t> closed;  ///< no open side and no void lets fluid out
};

/// What is known of each region of the fluid in a step.
struct Regions {
  std::vector<std::uint8_t> closed;     ///< as FlowRegions has them
  std::vector<std::uint8_t> compliant;  ///< a velocity of the solids that is free changes its volume
  std::vector<double> source;           ///< flux out of each cell that brings the region's volume back [volume/time]
  std::vector<std::size_t> cells;       ///< how many it has

  /// Returns whether fluid can get in or out of one.
  bool has_openings() const { return std::ranges::count(closed, 0) > 0; }
};

/// Says of each region whether it is closed: no open face joins it with a side or a void.
std::vector<std::uint8_t> closed_regions(const FlowDomain& domain);
FlowRegions regions_of(const FlowDomain& domain, const PressureNumbers& numbers);
/// Marks the regions that jets fill or empty at velocities v.
std::vector<std::uint8_t> regions_of_jets(const FlowDomain& domain, const FaceValues& v);

/// Closed regions of no more than a few cells that a surface cuts off from a larger one which sees it, too: a crevice
/// that the cells do not resolve. With pressures of its own it would hold the solids there as if it were welded.
std::vector<std::uint8_t> find_pockets(const FlowDomain& domain, const CouplingMap& map);
/// Returns the same of regions with these sizes, of which each sheet sees so much (as in a CouplingMap); pockets are no
/// larger than `most`.
std::vector<std::uint8_t> find_pockets(std::span<const double> sizes, std::span<const std::uint8_t> closed,
                                       std::span<const double> area_seen, double most);

/// `volumes` are those that the sheets enclose, `first` those at the start; `held` marks the solids' velocities that
/// are prescribed. A closed region's volume falls by what the volumes of the sheets that it sees grow; where several
/// regions see one sheet they share in it. `h` is the step in which it comes back [time].
Regions regions_of(const FlowRegions& of, const CouplingMap& map, std::span<const double> volumes,
                   std::span<const double> first, std::span<const std::uint8_t> held, double h);

/// The first region of those that jets fill or empty (`by_jets`), that a body and the box's sides close together and
/// whose volume nothing measures: no cavity's sheet bounds it, and the sheets that do bound other regions, too. -1:
/// none.
int unmeasured_region(std::span<const std::uint8_t> by_jets, const CouplingMap& map, const Regions& regions,
                      std::span<const std::uint8_t> cavity);

}  // namespace tether::coupled
