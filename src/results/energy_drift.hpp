// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <string_view>

#include "results/results.hpp"

namespace tether {

/// The sign by which a booked column goes into the energy that is kept; 0 for all others.
double sign_of(Book book);

/// Part of the pressure times the volume whose exchange is rest, for it is as much as what stands under that pressure
/// stores where it is strained by as much: whatever settles at all, within the first steps and to and fro.
constexpr double settling = 1e-3;

/// Largest change of the total energy less all that is booked in columns of its own, over the largest energy that was
/// exchanged: the largest change of any one kind or booked column. 0 where nothing was exchanged.
double energy_drift(const History& history);

/// Returns what the method itself lost by the end, over the same: negative where it gained.
double energy_lost(const History& history);

/// Returns what some of the method's losses took by the end, by the names of their columns, over the same. 0 where the
/// history has no such columns.
double energy_lost_by(const History& history, std::initializer_list<std::string_view> columns);

/// Largest rise of the total energy over the start but for what came from outside or went out, over the largest energy
/// that was exchanged, or that a fluid at rest may exchange by settling: a method that gains energy shows here, whether
/// it books that or not.
double energy_rise(const History& history);

/// Largest size of the total energy over its size at the start: how far an unstable run grew. Not a number where the
/// start has none, or only rounding of what then came from outside.
double energy_growth(const History& history);

/// Largest change of the mass over the mass at the start.
double mass_drift(const History& history);

}  // namespace tether
