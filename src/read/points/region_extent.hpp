// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "grid/boxes.hpp"
#include "read/points/geometry.hpp"

namespace tether {

/// How large a region is in the plane, and in space: a unit deep, or the whole ring's about an axis.
struct Extent {
  double area = 0, volume = 0;  // [length2], [volume]
};

/// How large a region is within the grid as the deck draws it, whatever points it gets: by lines across it, to about
/// 1e-5 of itself.
Extent drawn_extent(const RegionShape& shape, const BackgroundGrid& grid, Geometry geometry);

/// Returns the same for the part that two regions share.
Extent shared_extent(const RegionShape& one, const RegionShape& other, const BackgroundGrid& grid, Geometry geometry);

}  // namespace tether
