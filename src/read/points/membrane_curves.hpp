// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "read/points/curves.hpp"

namespace tether {

/// Curve k (from 1) of $membrane.
struct NumberedCurve {
  int k;
  Curve curve;
};

/// Returns whether $membrane gives a curve of any membrane.
bool gives_curves(const Deck& deck);

/// Numbers of the curves of membrane b, in their order.
std::vector<int> curve_numbers(const Deck& deck, int b);

/// The curves of membrane b. What is wrong with one is reported, and it is left out.
std::vector<NumberedCurve> curves_of(const Deck& deck, int b, Diagnostics& diagnostics);

/// Reports a curve that does not begin where the one before it ends.
void check_joints(const Deck& deck, const std::vector<NumberedCurve>& curves, Diagnostics& diagnostics);

/// Reports values of curves whose kind is not given.
void check_kinds(const Deck& deck, Diagnostics& diagnostics);

}  // namespace tether
