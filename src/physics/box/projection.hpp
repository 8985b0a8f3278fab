// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "algebra/sparse_matrix.hpp"
#include "physics/box/coupling_map.hpp"
#include "physics/box/outside.hpp"

namespace tether::coupled {

// What pressures do to the fluid. D is the flux out of the fluid's cells through faces, by their open areas; M the
// volume of fluid that a face's velocity moves.

/// L = (h/rho) D M^-1 D^T, both triangles; `by` is h/rho [time volume/mass].
SparseMatrix pressure_matrix(const FlowDomain& domain, const PressureNumbers& numbers, double by);
/// D v with what prescribed faces bring [volume/time].
std::vector<double> net_flux(const FlowDomain& domain, const PressureNumbers& numbers, const FaceValues& v);
/// v += (h/rho) M^-1 D^T p at open faces.
void add_pressure(const FlowDomain& domain, const PressureNumbers& numbers, std::span<const double> p, double by,
                  FaceValues& v);
/// Does the same at faces between two pressures alone.
void add_pressure_within(const FlowDomain& domain, const PressureNumbers& numbers, std::span<const double> p, double by,
                         FaceValues& v);
/// Sum of rho M v w / 2 over open faces [energy].
double kinetic_energy(const FlowDomain& domain, const FaceValues& v, const FaceValues& w, double density);
/// Sum over prescribed faces of p times the flux out of the fluid: the power that the fluid does there [power].
double prescribed_power(const FlowDomain& domain, const PressureNumbers& numbers, std::span<const double> p,
                        const FaceValues& v);

}  // namespace tether::coupled
