// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tether::fem {

/// What has been said of bodies on a mesh: 1 where it has.
struct ToldDoubts {
  long long left_grid = 0, turned = 0;
};

/// As part of what a run saves.
template <class Exchange>
void exchange(Exchange& with, ToldDoubts& told) {
  with("told_left_grid", told.left_grid), with("told_turned", told.turned);
}

}  // namespace tether::fem
