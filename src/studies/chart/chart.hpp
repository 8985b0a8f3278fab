// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "studies/reproduce/problem.hpp"
#include "studies/study.hpp"

namespace tether::chart {

/// Runs that grow finer one after the other: the overrides of each, and the size of its cells or steps.
struct Ladder {
  std::vector<std::vector<std::string>> overrides;
  std::vector<double> size;  ///< relative: a cell's by their number, a step's as it is
};

/// Runs by one path or method.
struct Family {
  std::string name;
  std::size_t deck = 0;                ///< of the study's decks
  std::vector<std::string> sets = {};  ///< group.name=value, of all its runs
  Ladder cells = {};
  Ladder steps = {};  ///< on the middle one of the meshes; none where the deck does not study them
  std::optional<double> space_order = {}, step_order = {};  ///< of theory
};

/// What a chart deck says.
struct Chart {
  Study study;               ///< its deck, and what all runs share
  published::Readout value;  ///< of a finished run
  published::Readout exact;  ///< the answer; empty: what the finest runs lead to
  std::vector<Family> families;
  std::optional<std::size_t> answered_by;  ///< family whose runs lead to a converged answer; none: the best bounded
  std::optional<std::array<std::size_t, 2>> setting;  ///< family and run that were published, from 0
};

}  // namespace tether::chart
