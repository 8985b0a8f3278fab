// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/words.hpp"
#include "grid/mesh.hpp"
#include "grid/mesh_place.hpp"
#include "laws/materials/hyperelastic.hpp"
#include "model/amplitude.hpp"

namespace tether {

/// How a step of the finite element path goes: the discrete gradient that keeps the energy, the mid-point rule, the
/// trapezoidal rule (Newmark's with beta = 1/4, gamma = 1/2), central differences with lumped masses; or no dynamics.
enum class Integrator { energy, midpoint, trapezoid, central, equilibrium };
template <>
inline constexpr std::array<Word<Integrator>, 4> words<Integrator>{{{Integrator::energy, "energy"},
                                                                    {Integrator::midpoint, "midpoint"},
                                                                    {Integrator::trapezoid, "trapezoid"},
                                                                    {Integrator::central, "central"}}};

/// One material of a mesh.
struct SolidRegion {
  std::string name;
  ElasticLaw law;
  double density = 0;                // of the reference shape [mass/volume]
  std::array<double, 3> velocity{};  // at the start
  std::array<double, 3> spin{};      // angular velocity about the region's centre of mass at the start [1/time]
};

/// A dead load on sides [force/area] or, without any, in the volume of a region [force/volume].
struct Load {
  Sides sides;
  int region = -1;  // from 0
  std::array<double, 3> force{};
  Amplitude amplitude;
};

/// Nodes that follow a prescribed displacement in some directions [length].
struct Support {
  std::vector<int> nodes;
  std::array<bool, 3> fixed{};
  std::array<double, 3> displacement{};
  Amplitude amplitude;
  int number = 0;  ///< of the deck's support, from 1; 0 of a wall
};

/// A place of a body whose path is recorded, and what the history calls it.
struct TrackedPlace {
  MeshPlace place;
  std::string name;
};

/// Elastic bodies on a mesh, as the deck's groups $mesh and $fem describe them.
struct Solids {
  Mesh mesh;
  std::vector<SolidRegion> regions;
  std::vector<Load> loads;
  std::vector<Support> supports;
  std::vector<TrackedPlace> tracked;
  Integrator integrator = Integrator::energy;
  double alpha = 0, beta = 0;     ///< Rayleigh damping alpha M + beta K [1/time], [time]
  double tolerance = 1e-11;       ///< of Newton's method: residual over the largest force
  bool from_equilibrium = false;  ///< starts in equilibrium with the loads of t = 0
};

}  // namespace tether
