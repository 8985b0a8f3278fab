// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "studies/combinations.hpp"

namespace tether {

/// The keys of a summary.txt that have numbers. Throws FileError.
std::map<std::string, double> summary_numbers(const std::filesystem::path& summary);

/// A run that has come to its end, with what the study wants of its files, where it ended well. A column that its
/// history does not have becomes a warning. Throws FileError.
FinishedRun finished_run(const Study& study, const Variant& variant, RunRecord record, bool reused,
                         const std::filesystem::path& folder);

}  // namespace tether
