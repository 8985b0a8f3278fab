// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/coupled.hpp"

namespace tether {

const std::array<const char*, 6> box_side_names{"left", "right", "bottom", "top", "back", "front"};

}  // namespace tether
