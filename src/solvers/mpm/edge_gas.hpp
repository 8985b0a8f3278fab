// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/edges.hpp"

namespace tether::mpm {

/// Gas on one side of an edge. `across` counts into the grid, `along` the edge's axis.
struct EdgeGas {
  double density = 0, across = 0, along = 0, pressure = 0;  // [mass/volume], [velocity], [stress]
};

/// The gas at an edge between what is outside and what is inside: the solution, on the edge, of the Riemann problem of
/// the two. For weak waves that is the theory of characteristics: what a subsonic inflow takes from the inside is the
/// wave that runs out, p - rho c u, and all else from outside; a supersonic one takes all from outside; a subsonic
/// outflow takes from outside the wave that runs in, p + rho c u, and all else from the inside; a supersonic one takes
/// nothing from outside. An outflow with nothing said of the outside has there what is inside: no wave runs in.
EdgeGas gas_on_edge(const Edge& edge, const EdgeGas& outside, const EdgeGas& inside, double gamma);

}  // namespace tether::mpm
