// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "studies/reproduce_problem.hpp"

namespace tether::published {

// What several problems read off their runs. Bodies count from 1.

double sum(const std::vector<double>& values);
double mean(const std::vector<double>& values);  ///< not a number of none

/// A number that no deck changes.
Readout constant(double value);

/// Young's modulus of a body; of a linear fluid its bulk modulus, of a gas its specific energy at the start.
Readout modulus(int body);
/// A row for it: what the thesis states of its problem is judged by itself.
Quantity stated_modulus(const std::string& name, int body, double value, const std::string& place);

/// A key of summary.txt.
Readout summary_value(const std::string& key);
/// What a quantity of the history is at the start and at the end.
Readout first_value(const std::string& quantity, std::size_t k = 1);
Readout last_value(const std::string& quantity, std::size_t k = 1);

/// Total energy lost from start to end, in per cent of the start's; negative where it grew.
double energy_lost_percent(const RunFiles& run);

/// The first time at which a quantity is as near to its last value as `band`, which is in its own unit.
double first_near_the_end(const RunFiles& run, const std::string& quantity, std::size_t k, double band);

/// Means over the columns of cells that hold points, of a field in the last snapshot: middles of the columns that are
/// counted from x = 0, and the means.
struct ColumnMeans {
  std::vector<double> x, mean;
};
ColumnMeans column_means(const RunFiles& run, const std::string& field);

/// Volume over the length of the line through a body's points, which stand for equal pieces of it: the thickness of a
/// string or membrane, its cross-section of unit depth.
Readout thickness(int body);

/// Number of a body's points.
Readout count_of(int body);

}  // namespace tether::published
