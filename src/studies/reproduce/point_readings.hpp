// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "model/scene.hpp"
#include "studies/reproduce/formula.hpp"

namespace tether::published {

// What readings find in the fields of points and nodes. The arguments are those of reading_functions(), in their order.
// Each throws FileError where the run did not write what is read.

/// The number of a snapshot, of `count`, that a word names. Throws FileError where there is none.
std::size_t snapshot_of(std::size_t count, const Argument& argument);

double mean(const Numbers& values);  ///< not a number of none

double points_sum(const RunFiles& run, const std::vector<Argument>& arguments);
double points_mean(const RunFiles& run, const std::vector<Argument>& arguments);
double points_min(const RunFiles& run, const std::vector<Argument>& arguments);
double points_max(const RunFiles& run, const std::vector<Argument>& arguments);
double points_where_least(const RunFiles& run, const std::vector<Argument>& arguments);
double point(const RunFiles& run, const std::vector<Argument>& arguments);
double nodes_sum(const RunFiles& run, const std::vector<Argument>& arguments);
double nodes_mean(const RunFiles& run, const std::vector<Argument>& arguments);
double nodes_min(const RunFiles& run, const std::vector<Argument>& arguments);
double nodes_max(const RunFiles& run, const std::vector<Argument>& arguments);

/// Over the columns of cells that hold points, counted from x = 0.
double columns_mean(const RunFiles& run, const std::vector<Argument>& arguments);
double front(const RunFiles& run, const std::vector<Argument>& arguments);
double columns_apart(const RunFiles& run, const std::vector<Argument>& arguments);

/// The points of a body stand for equal pieces of a line; those at its ends, which may have half a piece or a whole
/// one, do not count.
double thickness(const RunFiles& run, const std::vector<Argument>& arguments);
double thickness_about_axis(const RunFiles& run, const std::vector<Argument>& arguments);

/// The names that scene_value() takes.
std::vector<std::string> scene_value_names();

/// A number that follows from the scene alone, by an exact solution: "shock_speed" of a tube of two gases,
/// "piston_period" of a piston on a spring and a fluid. Throws std::domain_error where the scene has no such solution,
/// std::out_of_range for a name that is none.
double scene_value(const Scene& scene, const std::string& name);

/// Returns what a body's stress grows with: Young's modulus of a solid or a membrane, the bulk modulus of a linear
/// fluid, of a gas its specific energy at the start. Bodies count from 1; not a number where there is no such body.
double modulus_of(const Scene& scene, int body);

}  // namespace tether::published
