// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "grid/elements_across.hpp"
#include "model/solids.hpp"

namespace tether {

/// By how much bodies of elements of order 1 are too stiff, as they lock: where they bend, by shear that their straight
/// sides take for bending; where they hardly change their volume, by having too few ways to keep it.
struct Locking {
  std::string body;      ///< what it is called
  int across = 0;        ///< elements across the thin direction
  double thickness = 0;  ///< [length]
  double nu = 0;         ///< Poisson's ratio
  double too_stiff = 0;  ///< stiffness in bending over the true one, less 1
  bool bends = true;     ///< it is held, or long enough to bend without
  int enough = 0;        ///< elements across that would leave it too stiff by told_stiffness
};

/// From this on it is reported.
constexpr double told_stiffness = 0.05;

/// Of a body divided like this, with Lame's constants as they act in the plane.
double bending_too_stiff(ElementKind kind, const ElementsAcross& across, double lambda, double mu);

/// Of each connected body; none where elements are of order 2, which bend, or of fibres alone, which do not resist it.
std::vector<Locking> locking_of(const Solids& solids);

/// What is to be said of the one of those that bend that is most too stiff, nothing where it is not by told_stiffness;
/// `coupled` bodies have no other elements.
std::string locking_warning(const std::vector<Locking>& bodies, const Solids& solids, bool coupled);

}  // namespace tether
