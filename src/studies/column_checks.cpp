// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/column_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/ending.hpp"
#include "plan/load.hpp"
#include "run/make.hpp"
#include "studies/combinations.hpp"
#include "studies/meant.hpp"

namespace tether {
namespace {

using Names = std::vector<std::string>;

/// Scenes that are built at most: a mistake is worth some seconds.
constexpr std::size_t most_scenes = 100;

bool contains(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The columns of a run's history, before it is run; nothing where its scene cannot be built, which the run will tell.
std::optional<Names> columns_of(const Study& study, const Combination& combination) {
  Names columns;
  const Ending ending = end_of(study.file, [&] {
    Diagnostics of_the_run;
    const Loaded loaded = load_scene(read_deck(study, combination), {}, of_the_run);
    columns = make_solver(loaded.plan)->history_layout().column_names();
  });
  if (ending.exit_code != exit_done) return std::nullopt;
  return columns;
}

}  // namespace

void check_columns(const Study& study, StudyRemarks& remarks) {
  auto open = study.history_values;
  const auto all = combinations(study);
  bool all_known = all.size() <= most_scenes;
  Names seen;
  for (std::size_t c = 0; c < std::min(all.size(), most_scenes) && !open.empty(); ++c) {
    const auto columns = columns_of(study, all[c]);
    all_known = all_known && columns.has_value();
    for (const auto& name : columns.value_or(Names{})) {
      if (!contains(seen, name)) seen.push_back(name);
    }
    std::erase_if(open, [&](const WantedValue& wanted) { return contains(seen, wanted.value.column); });
  }
  if (!all_known) return;
  for (const auto& [value, variable, number] : open) {
    const auto message = fmt::format("no run's history.txt has a column '{}'", value.column);
    remarks.tell(variable, number, {{value.at, message, meant(value.column, seen)}});
  }
}

}  // namespace tether
