// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>

#include "laws/elastic.hpp"
#include "laws/elastic_response.hpp"
#include "laws/neo_hookean.hpp"
#include "laws/st_venant_kirchhoff.hpp"

namespace tether {

// The table of elastic laws. A law is a plain struct in a file of its own with
//
//   word, name          what the deck and people call it
//   of(constants)       the law of what the deck says of a region
//   numbers(), note()   its numbers, and what more is to be said of it, for people
//   plane_stress()      whether nothing holds plane bodies across
//   in_plane()          Lame's constants of small strains as they act in the plane, or in space; nothing of fibres
//   stiffness()         modulus of uniaxial small strains, or of a fibre
//   small_strains       whether it answers to 1 + 2 eps, small strains about the shape at the start, in place of
//                       C = F^T F; stress and shape are then those of the start
//   respond<dim>(C, at) energy density, second Piola-Kirchhoff stress 2 dPsi/dC and modulus 2 dS/dC at the reference
//                       place `at`, of plane bodies with the third direction held or free as the law says
//   across<2>(C)          the third direction of a plane body: its stretch, and the stress along it
//
// Kernels call it through std::visit, so that a law in the table which lacks one of these does not compile.

/// Every law an elastic body can obey.
using ElasticLaw = std::variant<LinearElastic, StVenantKirchhoff, NeoHookean, HoopFibre>;

/// Returns Young's modulus of small strains, of the law as it stands in the plane; of fibres theirs [stress].
inline double youngs_modulus(const ElasticLaw& any) {
  const auto lame = std::visit([](const auto& law) { return law.in_plane(); }, any);
  if (!lame) return std::visit([](const auto& law) { return law.stiffness(); }, any);
  return 2 * lame->mu * (1 + poisson_ratio(*lame));
}

/// Returns whether a law answers to small strains.
inline bool small_strains(const ElasticLaw& any) {
  return std::visit([](const auto& law) { return law.small_strains; }, any);
}

/// Of these, what material points obey, too, by their F: a point knows no place of the start that a fibre could ask,
/// and small strains have their rate form there (elastic.hpp).
using PointLaw = std::variant<StVenantKirchhoff, NeoHookean>;

}  // namespace tether
