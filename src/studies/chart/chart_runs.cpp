// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/chart/chart_runs.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace tether::chart {
namespace {

/// One of the base deck with these values.
Study study_of_run(const Chart& chart, const Family& family, const std::vector<std::string>& more) {
  Study study;
  study.file = chart.study.file, study.text = chart.study.text, study.title = chart.study.title;
  study.decks = {chart.study.decks[family.deck]};
  study.sets = chart.study.sets;
  study.sets.insert(study.sets.end(), family.sets.begin(), family.sets.end());
  study.sets.insert(study.sets.end(), more.begin(), more.end());
  return study;
}

/// Returns what errors are over: the answer, unless that is 0, as of a norm.
double measure_of(double answer) { return answer == 0 ? 1 : std::abs(answer); }

double distance(double value, double answer) { return std::abs(value - answer) / measure_of(answer); }

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

std::optional<Limit> trusted_limit(const Family& family, const std::vector<double>& values) {
  const std::size_t n = values.size();
  if (n < 3) return std::nullopt;
  const double most = family.space_order ? *family.space_order + 1 : 5;
  const std::span<const double> size = family.cells.size, value = values;
  Limit limit = limit_of(size, value);
  if (!limit.converges || limit.order < 0.5 || limit.order > most) return std::nullopt;
  if (n > 3) {
    const Limit before = limit_of(size.first(n - 1), value.first(n - 1));
    limit.bound = std::max(limit.bound, std::abs(limit.value - before.value));
  }
  return limit;
}

namespace {

/// The answer that is best bounded, or the named family's, and who contradicts it.
void find_converged(const Chart& chart, const std::vector<ChartRun>& runs, Measurement& measurement) {
  std::vector<std::optional<Limit>> limits;
  for (std::size_t f = 0; f < chart.families.size(); ++f)
    limits.push_back(trusted_limit(chart.families[f], numbers_of(runs, measurement, f, Of::cells, &Measured::value)));
  const Limit* best = nullptr;
  for (std::size_t f = 0; f < limits.size(); ++f) {
    if (!limits[f] || (chart.answered_by && *chart.answered_by != f)) continue;
    if (best && best->bound <= limits[f]->bound) continue;
    best = &*limits[f];
    measurement.answer = best->value, measurement.bound = best->bound, measurement.answered_by = f;
  }
  for (std::size_t f = 0; best && f < limits.size(); ++f) {
    if (limits[f] && std::abs(limits[f]->value - best->value) > limits[f]->bound + best->bound)
      measurement.contradicting.push_back(f);
  }
}

}  // namespace

void find_errors(const Chart& chart, const std::vector<ChartRun>& runs, Measurement& measurement) {
  if (chart.exact) {
    const auto found = std::find_if(measurement.runs.begin(), measurement.runs.end(),
                                    [](const Measured& run) { return std::isfinite(run.exact); });
    if (found != measurement.runs.end()) measurement.answer = found->exact;
  } else {
    find_converged(chart, runs, measurement);
  }
  for (Measured& run : measurement.runs) {
    const double exact = chart.exact && std::isfinite(run.exact) ? run.exact : measurement.answer;
    run.error = distance(run.value, exact);
  }
  for (std::size_t f = 0; f < chart.families.size(); ++f) {
    const auto kept = lasting(numbers_of(runs, measurement, f, Of::cells, &Measured::error));
    const double unknown = distance(measurement.answer + measurement.bound, measurement.answer);
    for (std::size_t k = 0; k < runs.size(); ++k) {
      if (runs[k].family != f || runs[k].of != Of::cells) continue;
      const double error = kept[runs[k].rung];
      measurement.runs[k].lasting = std::isfinite(error) ? std::max(error, unknown) : error;
    }
  }
}

std::vector<double> errors_of_steps(const std::vector<double>& size, const std::vector<double>& value, double answer) {
  if (size.size() < 3) return {};
  const Limit limit = limit_of(size, value);
  std::vector<double> errors;
  for (const double each : value)
    errors.push_back(limit.converges ? std::abs(each - limit.value) / measure_of(answer) : NAN);
  return errors;
}

}  // namespace tether::chart
