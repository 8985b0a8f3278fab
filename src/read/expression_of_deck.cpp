// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/expression_of_deck.hpp"

namespace tether {

std::shared_ptr<const Expression> expression_of(const Deck& deck, const std::string& group, const std::string& name,
                                                int k, std::vector<std::string> variables, Diagnostics& diagnostics) {
  try {
    return std::make_shared<const Expression>(deck.text(group, name, k), std::move(variables));
  } catch (const ExpressionError& error) {
    diagnostics.add(deck.remark_within(Severity::error, group, name, {k, 1}, error.at(), error.what(), error.hint()));
    return nullptr;
  }
}

}  // namespace tether
