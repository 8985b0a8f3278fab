// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "studies/reproduce_problem.hpp"

namespace tether::published {

// The thesis' numbers, a function a file.
std::vector<Problem> problems_of_chapter4();
std::vector<Problem> problems_of_chapter5();
std::vector<Problem> pendulums();
std::vector<Problem> problems_of_chapter6();
std::vector<Problem> membrane_expansions();
std::vector<Problem> airbags();
std::vector<Problem> problems_of_chapters7and8();
std::vector<Problem> two_bars();
std::vector<Problem> balls_and_nets();
std::vector<Problem> noise();

/// All of them, in the order of the thesis.
std::vector<Problem> all_problems();

/// Those of these names, in the order of the thesis; all where there are none. Throws InputError that tells of every
/// name that is none of a problem's, the nearest one, and the list.
std::vector<Problem> problems_named(const std::vector<std::string>& names);

}  // namespace tether::published
