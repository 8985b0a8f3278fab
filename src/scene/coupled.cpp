// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/coupled.hpp"

namespace tether {

bool AxisBox::contains(const std::array<double, 3>& place) const {
  for (std::size_t i = 0; i < 3; ++i) {
    if (place[i] < low[i] || place[i] > high[i]) return false;
  }
  return true;
}

}  // namespace tether
