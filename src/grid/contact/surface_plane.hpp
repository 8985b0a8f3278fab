// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/vec.hpp"

namespace tether {

/// A plane that places stay on one side of; a unit normal, to that side.
struct SurfacePlane {
  Vec<3> place{}, normal{};
};

}  // namespace tether
