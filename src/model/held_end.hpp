// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "model/scene.hpp"

namespace tether {

/// Where a string's first end is held.
struct HeldEnd {
  double x = 0, y = 0;  // [length]
  bool slides = false;  ///< along the wall that holds it
};

/// The pin of the string's first point, or the place where the line of its first two points meets a wall that holds
/// what is across it. Material points feel a wall from the cell beside it, and what is between the wall and the first
/// point stretches with that cell: the string begins at the wall. Bars say themselves where they begin. Nothing where
/// the end is free.
std::optional<HeldEnd> held_end(const Scene& scene, const Body& string);

}  // namespace tether
