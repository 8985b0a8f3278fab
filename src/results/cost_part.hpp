// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/seconds.hpp"

namespace tether {

/// What a part of a run took: "assembly", "solve" ...
struct CostPart {
  std::string name;
  Seconds taken;
};

}  // namespace tether
