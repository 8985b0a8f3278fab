// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace tether::mpm {

enum class TroubleKind { none, left_grid, jumped, unsound, at_open_edge };

/// The first point of a step whose numbers are no longer sound. Found inside the passes, reported after them.
struct Trouble {
  TroubleKind kind = TroubleKind::none;
  std::size_t slot = 0;

  /// Always false, so that a check can end with it.
  bool note(TroubleKind what, std::size_t p) {
    if (kind == TroubleKind::none) kind = what, slot = p;
    return false;
  }
  void join(const Trouble& later) {
    if (kind == TroubleKind::none) *this = later;
  }
};

}  // namespace tether::mpm
