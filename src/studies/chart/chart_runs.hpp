// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "studies/chart/chart.hpp"
#include "studies/chart/evaluation.hpp"

namespace tether::chart {

/// What a run studies.
enum class Of { cells, steps };

/// A run of a chart, as a study of its own.
struct ChartRun {
  std::size_t family = 0;
  Of of = Of::cells;
  std::size_t rung = 0;  ///< of the ladder
  Study study;
};

/// All of them, family by family: those of its cells, then those of its steps.
std::vector<ChartRun> runs_of(const Chart& chart);

/// What a run came to; not a number where it failed, or does not show it.
struct Measured {
  double value = std::numeric_limits<double>::quiet_NaN();
  double exact = value;
  double error = value;  ///< over the answer, where that is not 0
  /// The largest error of it, of the family's finer meshes, and of what a converged answer may be off; none of runs
  /// that study steps.
  double lasting = value;
  double seconds = value, megabytes = value;
  double step = value;  ///< the mean of those that it took: limits may cut the deck's own
};

/// What all runs came to, in their order, and the answer.
struct Measurement {
  std::vector<Measured> runs;
  double answer = std::numeric_limits<double>::quiet_NaN();
  double bound = 0;                             ///< of what a converged answer may be off
  std::size_t answered_by = 0;                  ///< the family whose runs it is from
  std::vector<std::size_t> contradicting = {};  ///< families that lead elsewhere, by more than both bounds
};

/// Returns what a family's cells lead to, as far as it can be trusted: its values come near it with an order of 0.5 or
/// more, and not above theory's by more than 1 (5 where there is none). The bound is the larger of its distance from
/// the finest value and that from what the meshes before led to. None for fewer than three meshes.
std::optional<Limit> trusted_limit(const Family& family, const std::vector<double>& values);

/// Errors from values, and where there is no exact answer, the answer: the limit that is best bounded of those that the
/// families' cells lead to.
void find_errors(const Chart& chart, const std::vector<ChartRun>& runs, Measurement& measurement);

/// The numbers of `of` of a family's runs, of its cells or its steps, in their order.
std::vector<double> numbers_of(const std::vector<ChartRun>& runs, const Measurement& measurement, std::size_t family,
                               Of of, double Measured::*number);

/// How far the values of a family's steps are from what they lead to, over the answer: what of the error is the step's.
std::vector<double> errors_of_steps(const std::vector<double>& size, const std::vector<double>& value, double answer);

/// The report, for people.
std::string report_text(const Chart& chart, const std::vector<ChartRun>& runs, const Measurement& measurement);

}  // namespace tether::chart
