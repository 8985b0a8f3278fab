// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/run_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

namespace tether {
namespace {

using Numbers = std::vector<double>;
using Texts = std::vector<std::string>;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// A cell a run: what `each` says of it.
template <class Each>
Numbers numbers(const std::vector<FinishedRun>& runs, const Each& each) {
  Numbers cells(runs.size());
  std::transform(runs.begin(), runs.end(), cells.begin(), each);
  return cells;
}

template <class Each>
Texts texts(const std::vector<FinishedRun>& runs, const Each& each) {
  Texts cells(runs.size());
  std::transform(runs.begin(), runs.end(), cells.begin(), each);
  return cells;
}

std::vector<Combination> combinations_of(const Study& study, const std::vector<FinishedRun>& runs) {
  const auto all = combinations(study);
  std::vector<Combination> rows;
  rows.reserve(runs.size());
  for (const auto& run : runs) rows.push_back(all[run.variant.combination]);
  return rows;
}

/// A column of numbers of the runs: a quantity, or an axis.
Numbers column_of(const StudyTable& table, const std::string& name) {
  const auto named = [&](const TableColumn& column) { return column.name == name; };
  return std::get<Numbers>(std::find_if(table.columns.begin(), table.columns.end(), named)->cells);
}

/// ln(e before / e) / ln(h before / h), of the run before along axis 1, the fastest: that of the combination before.
Numbers orders(const Study& study, const std::vector<FinishedRun>& runs, const Numbers& e, const Numbers& h) {
  const auto all = combinations(study);
  Numbers cells(runs.size(), missing);
  for (std::size_t k = 1; k < runs.size(); ++k) {
    const std::size_t here = runs[k].variant.combination, before = runs[k - 1].variant.combination;
    if (here != before + 1 || all[here].values[0] == 0) continue;
    const double order = std::log(std::abs(e[k - 1] / e[k])) / std::log(h[k - 1] / h[k]);
    if (std::isfinite(order)) cells[k] = order;
  }
  return cells;
}

std::string meaning_of(const Study& study, const std::string& key) {
  for (const auto& wanted : study.history_values) {
    if (wanted.value.name() == key) return wanted.value.meaning();
  }
  return "key of summary.txt";
}

void add_quantities(StudyTable& table, const Study& study, const std::vector<FinishedRun>& runs) {
  auto keys = study.quantities;
  const bool shown = std::find(keys.begin(), keys.end(), study.criterion.key) != keys.end();
  const bool own = !study.criterion.key.empty() && !shown && study.criterion.key != exit_code_key;
  if (own) keys.push_back(study.criterion.key);
  for (const auto& key : keys) {
    table.columns.push_back(
        {key, meaning_of(study, key), "", numbers(runs, [&](const auto& run) { return run.value(key); })});
  }
  if (study.order.empty()) return;
  const Numbers h = column_of(table, study.order);
  const std::string prefix = "error_";
  for (const auto& key : study.quantities) {
    if (!key.starts_with(prefix)) continue;
    table.columns.push_back({"order_" + key.substr(prefix.size()),
                             "observed order of " + key + " against " + study.order + " from the row above", "",
                             orders(study, runs, column_of(table, key), h)});
  }
}

void add_varied(StudyTable& table, const Study& study, const std::vector<FinishedRun>& runs) {
  if (study.vary.variable.empty()) return;
  table.columns.push_back({study.vary.variable, "deck value that is varied", "",
                           numbers(runs, [](const auto& run) { return run.variant.varied.value(); })});
}

}  // namespace

double count_warnings(const Ending& ending) {
  constexpr std::string_view word = "warning: ";
  const std::string& message = ending.message;
  double count = 0;
  if (ending.exit_code != exit_done) return count;
  for (auto at = message.find(word); at != std::string::npos; at = message.find(word, at + word.size())) ++count;
  return count;
}

namespace {

void add_endings(StudyTable& table, const std::vector<FinishedRun>& runs) {
  const auto add = [&](const char* name, const char* meaning, const char* unit, auto cells) {
    table.columns.push_back({name, meaning, unit, std::move(cells)});
  };
  add("cpu_seconds", "processor time of the run's process", "s",
      numbers(runs, [](const auto& run) { return run.record.cpu_seconds; }));
  add("wall_seconds", "wall time of the run's process", "s",
      numbers(runs, [](const auto& run) { return run.record.wall_seconds; }));
  add("exit_code", "0 done, 2 input wrong, 3 run diverged, 4 file trouble, 128 + n killed by signal n", "1",
      numbers(runs, [](const auto& run) { return run.record.ending.exit_code; }));
  add("warnings", "warnings of a run that came to its end, which stand in message", "1",
      numbers(runs, [](const auto& run) { return count_warnings(run.record.ending); }));
  add("message", "why the run failed, or its warnings", "",
      texts(runs, [](const auto& run) { return run.record.ending.message; }));
  add("folder", "folder of the run, from the table's", "",
      texts(runs, [](const auto& run) { return run_folder("", run.record.key).string(); }));
  add("reused", "1 where the run had been finished before", "1",
      numbers(runs, [](const auto& run) { return run.reused ? 1.0 : 0.0; }));
}

}  // namespace

std::vector<std::string> fixed_columns() {
  return {"run", "deck", "cpu_seconds", "wall_seconds", "exit_code", "warnings", "message", "folder", "reused"};
}

void add_inputs(StudyTable& table, const Study& study, const std::vector<Combination>& rows) {
  Texts decks;
  for (const auto& row : rows) decks.push_back(study.decks[row.deck].file);
  table.columns.push_back({"deck", "base deck", "", decks});
  for (std::size_t a = 0; a < study.axes.size(); ++a) {
    const StudyAxis& axis = study.axes[a];
    TableColumn column{axis.variable, "deck value", "", Numbers{}};
    if (std::holds_alternative<std::string>(axis.cells.front())) column.cells = Texts{};
    for (const auto& row : rows) {
      const Cell& cell = axis.cells[row.values[a]];
      if (auto* cells = std::get_if<Texts>(&column.cells)) cells->push_back(std::get<std::string>(cell));
      if (auto* cells = std::get_if<Numbers>(&column.cells)) cells->push_back(std::get<double>(cell));
    }
    table.columns.push_back(std::move(column));
  }
}

StudyTable run_table(const Study& study, const std::vector<FinishedRun>& runs) {
  const std::size_t each = study.mode == Mode::ensemble ? static_cast<std::size_t>(study.runs) : 1;
  Numbers number;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const Variant& variant = runs[k].variant;
    const std::size_t place =
        study.mode != Mode::grid && study.mode != Mode::ensemble ? k : variant.combination * each + variant.number;
    number.push_back(static_cast<double>(place + 1));
  }
  StudyTable table{"run", {{"run", "number of the run", "1", number}}};
  add_inputs(table, study, combinations_of(study, runs));
  add_varied(table, study, runs);
  add_quantities(table, study, runs);
  add_endings(table, runs);
  return table;
}

namespace {

using Numbers = std::vector<double>;
using Texts = std::vector<std::string>;

/// Those runs' values of a quantity that are numbers.
Numbers values_of(const std::vector<FinishedRun>& runs, std::size_t combination, const std::string& key) {
  Numbers values;
  for (const auto& run : runs) {
    const double value = run.value(key);
    if (run.variant.combination == combination && !std::isnan(value)) values.push_back(value);
  }
  return values;
}

double mean(const Numbers& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? missing : sum / static_cast<double>(values.size());
}

double spread(const Numbers& values) {
  if (values.size() < 2) return missing;
  double squares = 0;
  for (const double value : values) squares += (value - mean(values)) * (value - mean(values));
  return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

double least(const Numbers& values) {
  return values.empty() ? missing : *std::min_element(values.begin(), values.end());
}
double largest(const Numbers& values) {
  return values.empty() ? missing : *std::max_element(values.begin(), values.end());
}

/// A row for each combination, its inputs in it.
StudyTable combination_table(const Study& study) {
  const auto all = combinations(study);
  Numbers number;
  for (std::size_t c = 0; c < all.size(); ++c) number.push_back(static_cast<double>(c + 1));
  StudyTable table{"combination", {{"combination", "number of the combination", "1", number}}};
  add_inputs(table, study, all);
  return table;
}

/// How many runs of each combination there are that are so.
template <class So>
Numbers count_runs(const Study& study, const std::vector<FinishedRun>& runs, const So& so) {
  Numbers counts(combinations(study).size(), 0);
  for (const auto& run : runs) counts[run.variant.combination] += so(run) ? 1 : 0;
  return counts;
}

}  // namespace

StudyTable ensemble_table(const Study& study, const std::vector<FinishedRun>& runs) {
  StudyTable table = combination_table(study);
  table.columns.push_back({"runs", "number of runs", "1", count_runs(study, runs, [](const auto&) { return true; })});
  table.columns.push_back(
      {"failed", "runs that failed", "1", count_runs(study, runs, [](const auto& run) { return run.failed(); })});
  struct Statistic {
    const char *name, *meaning;
    double (*of)(const Numbers&);
  };
  for (const auto& key : study.quantities) {
    for (const auto& [name, meaning, of] :
         {Statistic{"mean_", "mean of ", mean}, Statistic{"spread_", "standard deviation (n - 1) of ", spread},
          Statistic{"min_", "least ", least}, Statistic{"max_", "largest ", largest}}) {
      Numbers cells;
      for (std::size_t c = 0; c < table.rows(); ++c) cells.push_back(of(values_of(runs, c, key)));
      table.columns.push_back({name + key, meaning + key, "", cells});
    }
  }
  return table;
}

StudyTable bisection_table(const Study& study, const std::vector<FinishedRun>& runs,
                           const std::vector<Bisection>& bisections) {
  StudyTable table = combination_table(study);
  Numbers holds, fails;
  Texts verdicts;
  for (const auto& bisection : bisections) {
    holds.push_back(bisection.holds());
    fails.push_back(bisection.fails());
    verdicts.push_back(bisection.verdict());
  }
  table.columns.push_back({"largest_holding", "largest " + study.vary.variable + " that holds", "", holds});
  table.columns.push_back({"smallest_failing", "smallest " + study.vary.variable + " that does not", "", fails});
  table.columns.push_back({"runs", "number of runs", "1", count_runs(study, runs, [](const auto&) { return true; })});
  table.columns.push_back({"verdict", "how the bisection ended", "", verdicts});
  return table;
}

}  // namespace tether
