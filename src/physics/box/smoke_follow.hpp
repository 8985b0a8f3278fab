// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "physics/box/smoke.hpp"

namespace tether::coupled {

/// Moves contents with a domain that solids have changed; in sum none is made or lost.
///
/// What is in cells that hold no fluid any more goes straight on through the faces that were open, in equal parts to
/// the nearest cells that stay fluid; where there are none, to those that are nearest anywhere; and where there is no
/// fluid it waits. A cell that a thin solid has gone over, so that a face between it and fluid has closed and another
/// has opened, gives up its contents in the same way through the faces that have closed. These cells and those that are
/// new take fluid from their neighbours through faces open now, and those beyond from these: of a neighbour with k
/// takers the part 1/(k + 1), over the number of the taker's neighbours. New fluid without such a neighbour is clean
/// and fills its cells. Both domains are of one grid.
void follow_domain(const FlowDomain& before, const FlowDomain& now, Smoke& smoke);

/// Draws volumes towards the cells' `own` [volume] without a change of any content in sum: through each open face goes
/// a sixteenth of the difference of filling between the cells beside, from the fuller one and as it is there. Cells
/// whose own volume is not positive take no part.
void settle_smoke(const FlowDomain& domain, const std::vector<double>& own, Smoke& smoke);

}  // namespace tether::coupled
