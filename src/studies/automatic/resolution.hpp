// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace tether::automatic {

/// How fine a run is: by how much its cells, and its steps, are smaller than the deck's own.
struct Resolution {
  double space = 1, time = 1;

  bool operator==(const Resolution&) const = default;
};

/// Orders of an error in the sizes of cells and steps; none where a deck has no cells, or no steps, to make smaller.
struct Orders {
  std::optional<double> space, time;
};

}  // namespace tether::automatic
