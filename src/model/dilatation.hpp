// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "base/words.hpp"
#include "grid/elements.hpp"
#include "laws/hyperelastic.hpp"

namespace tether {

/// What a law takes for the change of volume: that of each point, or the mean of it over an element, which does not
/// lock where the volume hardly changes. Automatic is the mean, but that of points in triangles and tetrahedra of order
/// 2 whose bulk modulus is no more than their stabiliser, where both are the same for small strains.
enum class Dilatation { automatic, point, mean };
template <>
inline constexpr std::array<Word<Dilatation>, 3> words<Dilatation>{
    {{Dilatation::automatic, "auto"}, {Dilatation::point, "point"}, {Dilatation::mean, "mean"}}};

/// How an element takes the dilatation of its law.
struct DilatationChoice {
  bool mean = false;
  double stabiliser = 0;  ///< modulus c of what the mean leaves out of the dilatation [stress]
};

/// Returns the dilatation that elements of a kind take: not the mean where the dilatation has one value in an element,
/// nor of a plane body which is free across, or of fibres alone.
DilatationChoice dilatation_of(Dilatation wanted, ElementKind kind, const ElasticLaw& law);

}  // namespace tether
