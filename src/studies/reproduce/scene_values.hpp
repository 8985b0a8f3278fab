// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "model/scene.hpp"

namespace tether::published {

/// The names that scene_value() takes.
std::vector<std::string> scene_value_names();

/// A number that follows from the scene alone, by an exact solution: "shock_speed" of a tube of two gases,
/// "piston_period" of a piston on a spring and a fluid. Throws std::domain_error where the scene has no such solution,
/// std::out_of_range for a name that is none.
double scene_value(const Scene& scene, const std::string& name);

/// What a body's stress grows with: Young's modulus of a solid or a membrane, the bulk modulus of a linear fluid, of a
/// gas its specific energy at the start. Bodies count from 1; not a number where there is no such body.
double modulus_of(const Scene& scene, int body);

}  // namespace tether::published
