// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <variant>

#include "model/scene.hpp"

namespace tether {

/// Why a scene is no strip: what is wrong, and what would be right.
struct NoStrip {
  std::string reason, hint;
};

/// Finds whether a scene of material points is a strip, by its grid, walls and loads and by its points.
std::variant<Strip, NoStrip> find_strip(const Scene& scene);

/// Returns how many points run: those of the row where the scene runs as one.
std::size_t points_that_run(const Scene& scene);

/// The scene of the row, which has a strip and no points: its bodies count the row's. Tracked points keep their numbers
/// in the strip.
Scene scene_of_row(const Scene& scene);
/// Makes the row's points of the strip's: in the middle, each with mass and volume of those that it stands for.
PointSet points_of_row(const Strip& strip, const PointSet& points);

}  // namespace tether
