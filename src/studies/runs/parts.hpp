// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "studies/runs/scheduler.hpp"

namespace tether {

/// What is expected of a part of studies: a run, or several one after the other.
struct PartCost {
  std::size_t number = 0;             ///< from 1
  double seconds = 0, megabytes = 0;  ///< of the processor, in all; the most memory
};

/// The numbers of the parts that are not finished, as far as finished runs lead.
std::set<std::size_t> unfinished_parts(const std::vector<StudyRun>& studies);

/// Finds what plans expect of these parts. Of many, some are looked at, spread evenly, and the others are expected to
/// be like the most costly one of their neighbours: plans of large scenes take their time. Scenes that cannot be built
/// cost nothing.
std::vector<PartCost> costs_of(const std::vector<StudyRun>& studies, const std::set<std::size_t>& parts);

/// Returns by what studies are known whose parts have the same numbers: digits of the SHA-256 of their texts and of the
/// runs that they want first.
std::string sum_of(const std::vector<StudyRun>& studies);

/// Does the parts that the options name; leaves the tables to who collects. Throws InputError where there is no such
/// part, or where `sum` is given and not that of the studies; Interrupted; FileError, also where a run could not read
/// or write a file.
void do_parts(const std::vector<StudyRun>& studies, const StudyOptions& options, const std::string& work,
              const std::string& sum);

/// "3,7-9" as numbers; none where it is no such list of numbers from 1.
std::optional<std::set<std::size_t>> part_numbers(const std::string& text);
std::string part_text(const std::vector<std::size_t>& numbers);  ///< and back, in their order

}  // namespace tether
