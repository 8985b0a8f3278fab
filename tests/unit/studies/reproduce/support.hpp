// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "studies/reproduce/problem.hpp"
#include "studies/reproduce/problems.hpp"
#include "studies/reproduce/read_formula.hpp"
#include "studies/reproduce/reproduce.hpp"
#include "unit/studies/reproduce/made_up.hpp"
#include "unit/temporary_folder.hpp"

namespace tether::published {

inline const std::filesystem::path decks = std::filesystem::path(TETHER_SOURCE_DIR) / "decks";

/// Those of this project's decks.
inline std::vector<Problem> all_problems() { return problems_named({}, decks); }
inline Problem problem_named(const std::string& name) { return problems_named({name}, decks).front(); }

/// A reading of a text that is right.
inline Readout readout(const std::string& text) {
  const ReadReading read = read_reading(text);
  EXPECT_TRUE(read.mistakes.empty()) << text << ": " << (read.mistakes.empty() ? "" : read.mistakes.front().message);
  return read.reading;
}
/// A printed number of a text that is right.
inline Printed printed(const std::string& text) { return read_printed(text).values.at(0); }

inline PublishedQuantity quantity_named(const std::string& problem, const std::string& name) {
  for (const PublishedQuantity& quantity : problem_named(problem).quantities) {
    if (quantity.name == name) return quantity;
  }
  ADD_FAILURE() << problem << " has no quantity " << name;
  return {};
}

/// What a problem's quantity reads off a run.
inline double read(const RunFiles& run, const std::string& problem, const std::string& quantity) {
  return quantity_named(problem, quantity).reading(run);
}

}  // namespace tether::published
