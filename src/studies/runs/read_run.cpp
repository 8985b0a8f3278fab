// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/runs/read_run.hpp"

#include <fmt/format.h>
#include <algorithm>

#include "base/numbers.hpp"
#include "results/summary_keys.hpp"

namespace tether {
namespace {

/// Reads what the study wants of a run that ended well. The other keys of its summary are left: of ten thousand runs
/// they would take hundreds of megabytes.
void read_numbers(const Study& study, const std::filesystem::path& folder, FinishedRun& run) {
  std::vector<HistoryValue> wanted;
  for (const WantedValue& each : study.history_values) wanted.push_back(each.value);
  auto [values, lacking] = read_history_numbers(folder / "history.txt", wanted);
  run.values = std::move(values);
  for (const auto& [key, number] : summary_numbers(folder / "summary.txt")) {
    if (key == study.criterion.key || std::ranges::find(study.quantities, key) != study.quantities.end())
      run.values.emplace(key, number);
  }
  run.lacking = std::move(lacking);
  std::string& message = run.record.ending.message;
  for (const auto& [column, hint] : run.lacking) {
    message +=
        fmt::format("{}warning: its history.txt has no column '{}'. {}", message.empty() ? "" : " ", column, hint);
  }
}

}  // namespace

std::map<std::string, double> summary_numbers(const std::filesystem::path& summary) {
  std::map<std::string, double> numbers;
  for (const auto& [key, text] : read_summary(summary)) {
    if (const auto number = parse_real(text)) numbers[key] = *number;
  }
  return numbers;
}

FinishedRun finished_run(const Study& study, const Variant& variant, RunRecord record, bool reused,
                         const std::filesystem::path& folder) {
  FinishedRun run{variant, std::move(record), reused, {}};
  if (!run.failed()) read_numbers(study, folder, run);
  return run;
}

}  // namespace tether
