// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/diagnostics.hpp"
#include "base/expression.hpp"
#include "deck/deck.hpp"

namespace tether {

/// The expression in these variables that a text of the deck is, or null where it is wrong, which is told under the
/// byte that is.
std::shared_ptr<const Expression> expression_of(const Deck& deck, const std::string& group, const std::string& name,
                                                int k, std::vector<std::string> variables, Diagnostics& diagnostics);

}  // namespace tether
