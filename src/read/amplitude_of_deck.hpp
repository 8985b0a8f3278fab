// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "model/amplitude.hpp"

namespace tether {

/// The factor that $group gives as what_time and what_factor in column k, or as what_expression(k); where it gives
/// neither, a static problem's grows in proportion to time.
Amplitude amplitude_of(const Deck& deck, const std::string& group, const std::string& what, int k,
                       Diagnostics& diagnostics);

}  // namespace tether
