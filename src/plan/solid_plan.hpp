// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <string>
#include <vector>

#include "model/solids.hpp"
#include "plan/plan.hpp"

namespace tether {

/// Describes elastic bodies on a mesh: the step, which is the deck's but for central differences; what is modelled; the
/// cost; and path, mesh and materials for people.
StepRule solid_step_rule(const Scene& scene);
std::vector<Term> solid_terms(const Solids& solids, double gravity);
Cost solid_cost(const Scene& scene, const StepRule& rule);
std::string solid_head(const Solids& solids);
/// Each region with its density and law, a line each.
std::string regions_text(const Solids& solids);
/// How many loads keep their direction, and how many are pressures.
std::string loads_text(const Solids& solids);
/// "bodies with each other, with themselves, with 4 walls and planes; gap 0.01, friction 0.3; damped, since friction
/// wants steady pressures".
std::string contact_text(const Contact& contact);
/// Each support and wall with the nodes that it holds or moves.
std::string supports_text(const Solids& solids);

/// An elastic law with its numbers.
template <class Law>
std::string law_text(const Law& law) {
  std::string text(Law::name);
  for (const auto& [name, value] : law.numbers()) text += fmt::format(", {} {:.4g}", name, value);
  return law.note().empty() ? text : fmt::format("{}, {}", text, law.note());
}

/// Describes a scene whose bodies on a mesh are one rigid body, stepped as the deck says: what is modelled, the cost,
/// and path, mesh and unknowns for people.
std::vector<Term> rigid_terms(const Scene& scene);
Cost rigid_cost(const Scene& scene, const StepRule& rule);
std::string rigid_head(const Scene& scene);

}  // namespace tether
