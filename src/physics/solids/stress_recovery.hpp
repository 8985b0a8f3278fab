// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "grid/mesh.hpp"

namespace tether::fem {

/// Stress of elements at the places where it is most exact, equally many of each element.
struct StressSamples {
  int per_element = 0;
  int order = 1;                ///< of the polynomials that fit them
  std::vector<double> places;   ///< of the shape at the start, dim numbers a sample [length]
  std::vector<double> stress;   ///< xx, yy, zz, xy, yz, xz of each sample
  std::vector<double> volumes;  ///< of the elements [volume]
};

/// Replaces the stress at nodes by that of polynomials, fitted by least squares to the samples of the elements around
/// each corner (O. C. Zienkiewicz and J. Z. Zhu, Int. J. Numer. Methods Engrg 33 (1992) 1331-1364). Where these are too
/// few for slopes, as at the boundary, those around them take part, too; none of another region does. A node that is no
/// corner has the mean of the corners of its elements, one of several regions their mean by volume. Nodes where slopes
/// are not determined, as in bodies of one element across, keep what they have. `nodal` has `stress_fields` numbers a
/// node.
void fit_stress(const Mesh& mesh, const StressSamples& samples, std::span<double> nodal);

}  // namespace tether::fem
