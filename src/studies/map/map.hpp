// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "studies/combinations.hpp"
#include "studies/reproduce/problem.hpp"
#include "studies/study.hpp"
#include "studies/table.hpp"

namespace tether::map {

/// What a map deck says: its axes span squares, in each of which the criterion holds or does not, or, where a value is
/// bisected, up to a value of its own.
struct Map {
  Study study;
  published::Readout theory;  ///< where its border should be; empty where the deck has none
};

/// What the runs came to.
struct Outcome {
  std::vector<FinishedRun> runs;
  std::vector<std::string> verdicts;                     ///< a run each
  std::vector<double> theory;                            ///< what is read off each run; not a number for none
  std::vector<std::optional<std::size_t>> decided_by{};  ///< the run, a square each; none where no run says anything
  std::vector<Bisection> bisections{};                   ///< a square each, in place of those
  bool finished = true;                                  ///< not where a signal came first
};

/// How a run stands to the criterion: "holds", "grows" above its bound or "falls short" of it; else how it failed, a
/// word of Failure; "tells nothing" where that is nothing of the scene.
std::string verdict_of(const Criterion& criterion, const FinishedRun& run);

/// Returns what theory says for a bisected square: the number read off the run of the largest value that holds.
double bisected_theory(const Outcome& outcome, std::size_t square);

/// Where the verdict changes between two neighbouring values of an axis.
struct Crossing {
  std::size_t square = 0;    ///< the one of both that comes first
  double low = 0, high = 0;  ///< the values
  bool holds_below = true;
  double theory = std::numeric_limits<double>::quiet_NaN();
};

/// Axes of several numbers, between which a border may lie, the last one first.
std::vector<std::size_t> border_axes(const Study& study);

/// The border of a map whose squares have verdicts: along the last axis of numbers on which there is any.
struct Border {
  std::optional<std::size_t> axis = {};
  std::vector<Crossing> crossings = {};  ///< by the values of the other axis
};
Border border_of(const Map& map, const Outcome& outcome);

/// A row a square: its values, its verdict and the run that decided it, or the bisected value; theory.
StudyTable squares_table(const Map& map, const Outcome& outcome);

/// The report, for people: a picture of the verdicts where there are two axes, the border next to theory, how many runs
/// were made of how many.
std::string report_text(const Map& map, const Outcome& outcome);

}  // namespace tether::map
