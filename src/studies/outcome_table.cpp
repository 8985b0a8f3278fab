// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/outcome_table.hpp"

#include <algorithm>
#include <cmath>

#include "studies/run_table.hpp"

namespace tether {
namespace {

using Numbers = std::vector<double>;
using Texts = std::vector<std::string>;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

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
