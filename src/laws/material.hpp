// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>

#include "laws/elastic.hpp"
#include "laws/finite_elastic.hpp"
#include "laws/fluids.hpp"

namespace tether {

/// Every law a body can obey.
using Material = std::variant<PlaneElastic, IdealGas, LinearFluid, Membrane, FiniteElastic>;

/// Elastic bodies that fill a region.
inline bool is_solid(const Material& material) {
  return std::holds_alternative<PlaneElastic>(material) || std::holds_alternative<FiniteElastic>(material);
}

/// A linear fluid with viscosity, whose friction heats it.
inline bool is_viscous_fluid(const Material& material) {
  const auto* fluid = std::get_if<LinearFluid>(&material);
  return fluid != nullptr && fluid->mu > 0;
}

}  // namespace tether
