// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "grid/thickness.hpp"
#include "model/solids.hpp"
#include "plan/plan.hpp"

namespace tether {

/// From this on a body that is too stiff or too soft is reported; elements that are off by less than the other are good
/// enough.
constexpr double told_stiffness = 0.05, good_stiffness = 0.02;

/// Returns by how much a body divided like this is too stiff where it bends, below 0 where it is too soft, with Lame's
/// constants as they act in the plane; `mean` says whether the law sees the mean dilatation.
double bending_too_stiff(ElementKind kind, const ElementsAcross& across, double lambda, double mu, bool mean);

/// Estimates how each connected body bends; nothing of fibres alone, which do not resist it.
std::vector<Bending> bending_of(const Solids& solids);

/// Says what is to be said of the one of those that bend that is most off. It says nothing where that is off by less
/// than told_stiffness.
std::string bending_warning(const std::vector<Bending>& bodies, const Solids& solids);

/// Says of the first body that bends that its elements are slanted so far that the estimate does not hold.
std::string lean_warning(const std::vector<Bending>& bodies);

/// Says of a region of St Venant and Kirchhoff's law that hardly changes its volume that it locks at finite strains:
/// its energy lambda/2 (tr E)^2 is no function of the volume.
std::string trace_warning(const Solids& solids);

/// A line for each body that bends with its elements and the estimate, and another with better ones where these are off
/// by more than good_stiffness.
std::string bending_text(const std::vector<Bending>& bodies, const Solids& solids);

}  // namespace tether
