// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/coupled.hpp"

namespace tether {

bool AxisBox::contains(const std::array<double, 3>& place) const {
  for (std::size_t i = 0; i < 3; ++i) {
    if (place[i] < low[i] || place[i] > high[i]) return false;
  }
  return true;
}

const char* coupling_mode_name(CouplingMode mode) {
  constexpr std::array names{"symmetric", "cut-cell", "splitting", "paper"};
  return names[static_cast<std::size_t>(mode)];
}

}  // namespace tether
