// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "studies/assignment.hpp"
#include "studies/reproduce/formula.hpp"

namespace tether::published {

/// The formula that a text is. Mistakes are noted at their columns of the whole text, in which this one begins at byte
/// `begin`; a formula with a mistake must not be evaluated.
std::shared_ptr<const Formula> read_formula(const std::string& text, std::size_t begin, std::vector<Mistake>& mistakes);

}  // namespace tether::published
