// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "solvers/coupled/flow_domain.hpp"

namespace tether::coupled {

/// What comes in through a face that a jet or the fluid outside is at.
struct SmokeJet {
  int axis = 0;
  std::size_t face = 0;
  double density = 0, temperature = 0;
};

/// What goes through the faces across an axis, seen from the cells beside: cell c has its next ones at c + stride and
/// c - stride.
struct SmokePassages {
  /// A face with no fluid on one of its sides.
  struct Outer {
    std::size_t cell;  ///< on the other
    bool upper;        ///< side of that cell that the face is
    int jet = -1;      ///< that it comes from, by its place among the jets
    double rate = 0;   ///< [volume/time]
  };

  std::ptrdiff_t stride = 1;
  std::vector<double> up, down;  ///< out of each cell through its upper and its lower face, 0 or positive [volume/time]
  std::vector<double> has_slope;  ///< 1 for cells with fluid on both sides and both faces not closed, else 0
  std::vector<Outer> in, out;
};

SmokePassages smoke_passages(const FlowDomain& domain, int axis, const std::vector<double>& v,
                             const std::vector<SmokeJet>& jets);

}  // namespace tether::coupled
