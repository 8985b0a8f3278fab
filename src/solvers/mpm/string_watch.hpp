// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "scene/scene.hpp"
#include "solvers/mpm/state.hpp"

namespace tether::mpm {

/// Looks whether the strings and membranes still hold together, and how far apart neighbours are. What there is to
/// warn of, once a run: neighbours of which neither feels the other, or between which fluid passes.
std::optional<std::string> watch_strings(State& state, const Scene& scene);

}  // namespace tether::mpm
