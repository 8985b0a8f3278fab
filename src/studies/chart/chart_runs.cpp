// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/chart/chart_runs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tether::chart {
namespace {

/// One of the base deck with these values.
Study study_of_run(const Chart& chart, const Family& family, const std::vector<std::string>& more) {
  Study study;
  study.file = chart.study.file, study.text = chart.study.text, study.title = chart.study.title;
  study.decks = chart.study.decks;
  study.sets = chart.study.sets;
  study.sets.insert(study.sets.end(), family.sets.begin(), family.sets.end());
  study.sets.insert(study.sets.end(), more.begin(), more.end());
  return study;
}

double distance(double value, double answer) { return std::abs(value - answer) / std::abs(answer); }

}  // namespace

std::vector<ChartRun> runs_of(const Chart& chart) {
  std::vector<ChartRun> runs;
  for (std::size_t f = 0; f < chart.families.size(); ++f) {
    const Family& family = chart.families[f];
    const auto& cells = family.cells.overrides;
    for (std::size_t k = 0; k < cells.size(); ++k)
      runs.push_back({f, Of::cells, k, study_of_run(chart, family, cells[k])});
    for (std::size_t k = 0; k < family.steps.overrides.size() && !cells.empty(); ++k) {
      auto more = cells[cells.size() / 2];
      more.insert(more.end(), family.steps.overrides[k].begin(), family.steps.overrides[k].end());
      runs.push_back({f, Of::steps, k, study_of_run(chart, family, more)});
    }
  }
  return runs;
}

std::vector<double> numbers_of(const std::vector<ChartRun>& runs, const Measurement& measurement, std::size_t family,
                               Of of, double Measured::*number) {
  std::vector<double> numbers;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (runs[k].family == family && runs[k].of == of) numbers.push_back(measurement.runs[k].*number);
  }
  return numbers;
}

void find_errors(const Chart& chart, const std::vector<ChartRun>& runs, Measurement& measurement) {
  if (chart.exact) {
    const auto found = std::find_if(measurement.runs.begin(), measurement.runs.end(),
                                    [](const Measured& run) { return std::isfinite(run.exact); });
    if (found != measurement.runs.end()) measurement.answer = found->exact;
  } else {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f < chart.families.size(); ++f) {
      const auto values = numbers_of(runs, measurement, f, Of::cells, &Measured::value);
      if (values.size() < 3) continue;
      const Limit limit = limit_of(chart.families[f].cells.size, values);
      if (!limit.converges || !(limit.bound < least)) continue;
      least = limit.bound;
      measurement.answer = limit.value, measurement.bound = limit.bound, measurement.answered_by = f;
    }
  }
  for (Measured& run : measurement.runs) {
    const double exact = chart.exact && std::isfinite(run.exact) ? run.exact : measurement.answer;
    run.error = distance(run.value, exact);
  }
  for (std::size_t f = 0; f < chart.families.size(); ++f) {
    const auto kept = lasting(numbers_of(runs, measurement, f, Of::cells, &Measured::error));
    for (std::size_t k = 0; k < runs.size(); ++k) {
      if (runs[k].family == f && runs[k].of == Of::cells) measurement.runs[k].lasting = kept[runs[k].rung];
    }
  }
}

std::vector<double> errors_of_steps(const std::vector<double>& size, const std::vector<double>& value, double answer) {
  if (size.size() < 3) return {};
  const Limit limit = limit_of(size, value);
  std::vector<double> errors;
  for (const double each : value)
    errors.push_back(limit.converges ? std::abs(each - limit.value) / std::abs(answer) : NAN);
  return errors;
}

}  // namespace tether::chart
