// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>

#include "laws/material.hpp"

namespace tether::mpm {

// Whether a law is updated only after all points of the body have moved: it asks for tangents or densities at their new
// places. `moves`: points have moved before their stress.

inline bool waits(const PlaneElastic&, bool) { return false; }
inline bool waits(const FiniteElastic&, bool) { return false; }
inline bool waits(const LinearFluid&, bool) { return false; }
inline bool waits(const Membrane&, bool) { return true; }
/// Says whether gas waits. Where the points stay, the gas at the nodes is known before the pass.
inline bool waits(const IdealGas& gas, bool moves) {
  return gas.rule == DensityRule::grid ? moves : gas.rule != DensityRule::continuity;
}
inline bool waits(const Material& material, bool moves) {
  return std::visit([moves](const auto& law) { return waits(law, moves); }, material);
}

}  // namespace tether::mpm
