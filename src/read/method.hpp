// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "model/method.hpp"

namespace tether {

/// The deck's method: a part that is given wins over the set. Reports parts that do not go together.
Method method_of(const Deck& deck, Diagnostics& diagnostics);

/// Factor of the step limit: the deck's, or that of its method.
double cfl_of(const Deck& deck);

/// The set of method='robust'.
Method robust_set();

/// Returns whether the deck asks for the robust set.
bool is_robust(const Deck& deck);

}  // namespace tether
