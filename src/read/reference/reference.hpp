// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "model/scene.hpp"

namespace tether {

/// The kind of a name of $reference solution; none for "".
ReferenceKind reference_kind(const std::string& name);

/// The exact solution that $reference names, and whether the scene has what it needs.
ReferenceKind reference_of(const Deck& deck, const Scene& scene, Diagnostics& diagnostics);

/// The part of the tube that $reference window asks for, once the scene has its solution.
std::optional<std::array<double, 2>> reference_window_of(const Deck& deck, const Scene& scene,
                                                         Diagnostics& diagnostics);

}  // namespace tether
