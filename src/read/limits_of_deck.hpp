// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "model/limits.hpp"

namespace tether {

/// What $limits says, by default what Limits has.
Limits limits_of(const Deck& deck, Diagnostics& diagnostics);

}  // namespace tether
