// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tether::fem {

/// What has been said of bodies on a mesh, 1 where it has; and what it is said by.
struct ToldDoubts {
  long long left_grid = 0, turned = 0, swings = 0;
  long long looks = 0, reversals = 0;  ///< steps that moved, and those of them that turned the motion back
  double fastest = 0;                  ///< largest kinetic energy so far, as turned_back() takes it
  double spacing = 0;   ///< largest distance of nodes that a fluid carries so far, over that of the fluid's
  double thinnest = 0;  ///< cells of the fluid across the thinnest body, the least so far
};

/// As part of what a run saves.
template <class Exchange>
void exchange(Exchange& with, ToldDoubts& told) {
  with("told_left_grid", told.left_grid), with("told_turned", told.turned), with("told_swings", told.swings);
  with("told_looks", told.looks), with("told_reversals", told.reversals), with("told_fastest", told.fastest);
  with("told_spacing", told.spacing), with("told_thinnest", told.thinnest);
}

}  // namespace tether::fem
