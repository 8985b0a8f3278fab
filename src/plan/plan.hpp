// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "model/scene.hpp"
#include "model/solids.hpp"

namespace tether {

/// By how much a body of elements is too stiff or too soft where it bends.
struct Bending {
  std::string body;      ///< what it is called
  int across = 0;        ///< elements across the thin direction
  double thickness = 0;  ///< [length]
  double nu = 0;         ///< Poisson's ratio
  double too_stiff = 0;  ///< estimate of the stiffness in bending over the true one, less 1
  double lean = 0;       ///< how far edges lean from the right angle, of which the estimate knows nothing [rad]
  bool bends = true;     ///< it is held, or long enough to bend without
  int enough = 0;        ///< elements of the same kind across that would be off by told_stiffness
  // The cheapest elements of order 2 that are off by little.
  int better_across = 1;
  double better_along = 0;  ///< their length [length]
  double better_off = 0;    ///< how much these are too stiff
};

/// dt = min(deck's step, cfl limit); cfl 0: the deck's step. The limit of material points is h / c, c = sqrt(E / rho)
/// for solids and strings, c + |v| for gas; that of explicit elements is 2 over their highest frequency.
struct StepRule {
  double deck_step = 0;    // [time]
  double cfl = 1;          // number
  double h = 0;            // smaller side of a cell [length]
  double solid_speed = 0;  // largest c of all but gas, constant in time [velocity]
  double first_limit = 0;  // at the start; infinite where nothing has a speed [time]
  double element_limit = std::numeric_limits<double>::infinity();  // of explicit elements, constant in time [time]
  const char* limit_name = "dx/c";                                 // what the limit is, for people

  double sharp_limit = 0;  // what pressure waves and viscosity allow; not part of the rule [time]

  /// The limit while the fastest wave of the gas has this speed (0 without gas); infinite where nothing has a speed.
  double limit(double gas_wave) const {
    const double fastest = std::max(solid_speed, gas_wave);
    return fastest > 0 ? std::min(element_limit, h / fastest) : element_limit;
  }
  double step(double gas_wave) const { return within(limit(gas_wave)); }
  double first_step() const { return within(first_limit); }

 private:
  double within(double limit) const { return cfl == 0 ? deck_step : std::min(deck_step, cfl * limit); }
};

/// A part of the model: whether it is there, and why.
struct Term {
  std::string name;
  bool on = false;
  std::string reason;
};

/// What a run is expected to cost: CPU seconds and the peak of memory of the whole process.
struct Cost {
  double steps = 0, point_steps = 0, megabytes = 0, seconds = 0;
  long long rehearsed = 0;  ///< steps, made on trial, from which this was found; 0: an estimate by formulas
};

/// What will be modelled, what is left out and why. Owns the scene.
struct Plan {
  Scene scene;
  StepRule step;
  std::vector<Term> terms;
  Cost cost;
  std::vector<Bending> bending;  ///< of bodies on a mesh
  std::vector<std::string> warnings;
};

}  // namespace tether
