// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <variant>

#include "base/place.hpp"

namespace tether {

/// One value of the deck and where it was written.
struct DeckValue {
  std::variant<long long, double, bool, std::string> data;
  Place place;
};

}  // namespace tether
