// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "solvers/coupled/smoke.hpp"

namespace tether::coupled {

/// A face that something flows through: out of cell `from`, into cell `to`, -1 being outside the fluid; `behind` is the
/// fluid cell that `from` has on its other side, -1 where none can be reached.
struct SmokePassage {
  int from = -1, to = -1, behind = -1;
  int jet = -1;     ///< that it comes from, by its place among the jets
  double rate = 0;  ///< positive [volume/time]
};

/// The passages across each axis, in the order of the faces.
std::array<std::vector<SmokePassage>, 3> smoke_passages(const FlowDomain& domain, const FaceValues& v,
                                                        const std::vector<SmokeJet>& jets);

}  // namespace tether::coupled
