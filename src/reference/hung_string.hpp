// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/scene.hpp"
#include "reference/oscillators.hpp"

namespace tether {

/// A scene's string from where it is held to its last point, the mass: uniform, with the section of its points.
struct HungString {
  double x = 0, y = 0;     // where it is held; its first point where nothing holds it [length]
  double length = 0;       // from there to the mass [length]
  double stiffness = 0;    // E A / L [force/length]
  double mass = 0;         // of the last point
  double string_mass = 0;  // of the rest, from where it is held
  double slack = 0;        // length that the stresses at the start say is too much [length]
};
HungString hung_string(const Scene& scene);

// The solutions of such scenes.
SpringMass spring_of(const Scene& scene);
StringBounce string_bounce_of(const Scene& scene);
Pendulum pendulum_of(const Scene& scene);
Piston piston_of(const Scene& scene);

}  // namespace tether
