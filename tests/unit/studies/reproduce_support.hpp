// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "studies/reproduce_problems.hpp"
#include "studies/reproduce_readings.hpp"
#include "studies/reproduce_report.hpp"
#include "unit/studies/reproduce_made_up.hpp"
#include "unit/temporary_folder.hpp"

namespace tether::published {

inline Problem problem_named(const std::string& name) { return problems_named({name}).front(); }

inline Quantity quantity_named(const std::string& problem, const std::string& name) {
  for (const Quantity& quantity : problem_named(problem).quantities) {
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
