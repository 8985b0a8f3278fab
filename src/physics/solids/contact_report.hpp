// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "physics/solids/step.hpp"
#include "results/results.hpp"

namespace tether::fem {

// What runs with bodies that meet say of it.

/// Reports each of what contact found doubtful once: what is in `now` that was not in `before`.
void report_contact(const ContactDoubts& before, const ContactDoubts& now, double time,
                    std::vector<std::string>& messages);
/// Adds the lines that bodies with contact have in summary.txt; none without.
void add_contact_summary(const Solids& solids, const ContactDoubts& doubts, Summary& summary);
/// Says of a step that Newton's method did not end, with the fastest node and a likely cause of what the scene has.
[[noreturn]] void refuse_step(const SolidState& state, const Solids& solids, double dt, const NewtonReport& report);

}  // namespace tether::fem
