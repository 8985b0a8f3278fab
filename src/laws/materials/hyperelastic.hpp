// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <variant>

#include "laws/materials/hoop_fibre.hpp"
#include "laws/materials/neo_hookean.hpp"
#include "laws/materials/st_venant_kirchhoff.hpp"

// The table of elastic laws. A law is a plain struct in a file of its own with
//
//   small_strains       whether it answers to 1 + 2 eps, small strains about the shape at the start, in place of
//                       C = F^T F; stress and shape are then those of the start
//   respond<dim>(C, at) energy density, second Piola-Kirchhoff stress 2 dPsi/dC and modulus 2 dS/dC at the reference
//                       place `at`, of plane bodies with the third direction held or free as the law says
//   across(C)           the third direction of a plane body: its stretch, and the stress along it
//
// Kernels call it through std::visit, so that a law in the table which lacks one of these does not compile.

namespace tether {

template <class Law>
concept Elastic = requires(const Law& law, const Symmetric<2>& plane, const Symmetric<3>& space, ReferencePlace at) {
  { Law::small_strains } -> std::convertible_to<bool>;
  { law.template respond<2>(plane, at) } -> std::same_as<Response<2>>;
  { law.template respond<3>(space, at) } -> std::same_as<Response<3>>;
  { law.across(plane) } -> std::same_as<Across>;
};

template <Elastic... Laws>
using LawTable = std::variant<Laws...>;

/// Every law an elastic body can obey.
using ElasticLaw = LawTable<LinearElastic, StVenantKirchhoff, NeoHookean, HoopFibre>;

}  // namespace tether
