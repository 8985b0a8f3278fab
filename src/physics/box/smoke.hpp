// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "base/team.hpp"
#include "physics/box/outside.hpp"

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

/// Smoke in the cells. The volume of fluid is carried by the same fluxes as the rest, so that smoke of the same density
/// everywhere stays so whatever the flow, also where solids move and cells gain or lose fluid by it; it need not be the
/// cell's own, and settle_smoke draws it there.
struct Smoke {
  std::vector<double> volume;  ///< of the fluid in a cell [volume]
  std::vector<double> smoke;   ///< density of smoke times volume
  std::vector<double> heat;    ///< temperature above that of the surroundings times volume [temperature volume]

  double density(std::size_t cell) const { return of_volume(smoke[cell], cell); }
  double temperature(std::size_t cell) const { return of_volume(heat[cell], cell); }

 private:
  double of_volume(double content, std::size_t cell) const { return volume[cell] > 0 ? content / volume[cell] : 0; }
};

/// What came in and went out, of smoke and of heat.
struct SmokeFlow {
  double smoke_in = 0, smoke_out = 0, heat_in = 0, heat_out = 0;
};

/// Fluid cells full of clean fluid.
Smoke clean_smoke(const FlowDomain& domain);

/// Carries smoke and heat along with v for a time h through faces that are not closed: linear in each cell, with van
/// Leer's limit, one axis after the other and back, in an even number of equal steps, such that no cell gives away more
/// than four fifths of its volume along an axis in one. There are at most 64; beyond that, as in any one step, a cell
/// gives nine tenths at most. What comes in through listed faces is theirs; from others it is
/// clean. Contents change by nothing but what is returned. Order 2 for smooth flows. Source: van Leer, J.
/// Comput. Phys. 14, 361 (1974).
SmokeFlow carry_smoke(Team& team, const FlowDomain& domain, const FaceValues& v, double h,
                      const std::vector<SmokeJet>& jets, Smoke& smoke);

/// Adds to the velocities v of open faces across y what smoke and warmth do in a time h: h (lift T - weight s), by the
/// mean of the fluid cells beside. `lift` and `weight` are accelerations by a temperature and a density of 1.
void add_buoyancy(const FlowDomain& domain, const Smoke& smoke, double lift, double weight, double h, FaceValues& v);
/// The power of the same on a fluid of this density at velocities v [power].
double buoyancy_power(const FlowDomain& domain, const Smoke& smoke, double lift, double weight, double density,
                      const FaceValues& v);

}  // namespace tether::coupled
