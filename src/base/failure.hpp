// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "base/words.hpp"

namespace tether {

/// How a run goes wrong.
enum class Failure { diverges, loses_points, inverts, does_not_converge, contradicts_energy };

template <>
inline constexpr std::array<Word<Failure>, 5> words<Failure>{{
    {Failure::diverges, "diverges"},                         // numbers overflow, or steps vanish
    {Failure::loses_points, "loses points"},                 // a point leaves its grid, a node the mesh around it
    {Failure::inverts, "inverts"},                           // a point or an element is turned inside out
    {Failure::does_not_converge, "does not converge"},       // iterations of a step, or of an equilibrium
    {Failure::contradicts_energy, "contradicts its energy"}  // which rises though no exchange explains it
}};

}  // namespace tether
