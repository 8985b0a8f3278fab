// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tether::fem {

/// Nodes inside another body.
struct OverlapCount {
  long long now = 0;
  long long most = 0;  ///< at one time since the start
};

/// As part of what a run saves.
template <class Exchange>
void exchange(Exchange& with, OverlapCount& count) {
  with("nodes_inside", count.now), with("nodes_inside_most", count.most);
}

}  // namespace tether::fem
