// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "studies/chart/chart_runs.hpp"

namespace tether::chart {
namespace {

constexpr std::array tolerances{0.1, 0.03, 0.01, 0.003, 0.001};

std::string percent(double part) { return std::isfinite(part) ? fmt::format("{:.3g} %", 100 * part) : "-"; }

/// A factor below this is within what processor times scatter by.
constexpr double least_factor = 1.2;

/// "run 3, family: in.nx=9", with the first of the values that make it finer.
std::string name_of(const Chart& chart, const std::vector<ChartRun>& runs, std::size_t k) {
  const Family& family = chart.families[runs[k].family];
  const std::size_t own = chart.study.sets.size() + family.sets.size();
  return fmt::format("run {}, {}: {}", k + 1, family.name, runs[k].study.sets[own]);
}

std::vector<Point> points_of(const Measurement& measurement, double Measured::*cost) {
  std::vector<Point> points;
  for (const Measured& run : measurement.runs) points.push_back({run.*cost, run.lasting});
  return points;
}

std::string answer_text(const Chart& chart, const Measurement& measurement) {
  if (!std::isfinite(measurement.answer))
    return "no answer: no run shows the exact one, or no family's cells converge with an order that can be trusted\n";
  if (chart.exact)
    return fmt::format("answer {:.8g}, exact{}\n", measurement.answer,
                       measurement.answer == 0 ? "; errors are absolute" : "");
  std::string text = fmt::format("answer {:.8g} +- {:.2g}, converged: what the cells of {} lead to, by Richardson\n",
                                 measurement.answer, measurement.bound, chart.families[measurement.answered_by].name);
  for (const std::size_t f : measurement.contradicting)
    text +=
        fmt::format("  {} leads elsewhere, by more than both bounds: models differ, or an answer is not that good\n",
                    chart.families[f].name);
  return text;
}

std::string front_text(const Chart& chart, const std::vector<ChartRun>& runs, const Measurement& measurement,
                       const char* of, double Measured::*cost, const char* unit) {
  std::string text = fmt::format("\nno run beats these in lasting error and {}:\n", of);
  const auto points = points_of(measurement, cost);
  for (const std::size_t k : front(points))
    text += fmt::format("  {:>10} {:>10.4g} {}  {}\n", percent(points[k].error), points[k].cost, unit,
                        name_of(chart, runs, k));
  return text;
}

/// Seconds for each tolerance, a line a family.
std::string cheapest_of_families(const Chart& chart, const std::vector<ChartRun>& runs,
                                 const Measurement& measurement) {
  std::string text = "\nits seconds by each family alone, for a lasting error of\n";
  for (const double tolerance : tolerances) text += fmt::format("{:>10}", percent(tolerance));
  for (std::size_t f = 0; f < chart.families.size(); ++f) {
    auto points = points_of(measurement, &Measured::seconds);
    for (std::size_t k = 0; k < runs.size(); ++k) {
      if (runs[k].family != f) points[k].error = NAN;
    }
    text += "\n";
    for (const double tolerance : tolerances) {
      const auto best = cheapest(points, tolerance);
      text += fmt::format("{:>10}", best ? fmt::format("{:.3g}", points[*best].cost) : "-");
    }
    text += "  " + chart.families[f].name;
  }
  return text + "\n";
}

std::string cheapest_text(const Chart& chart, const std::vector<ChartRun>& runs, const Measurement& measurement) {
  std::string text = "\nthe cheapest choice for a lasting error of\n";
  const auto points = points_of(measurement, &Measured::seconds);
  for (const double tolerance : tolerances) {
    const auto best = cheapest(points, tolerance);
    text += fmt::format("  {:>6}  {}\n", percent(tolerance),
                        best ? fmt::format("{:.4g} s  {}", points[*best].cost, name_of(chart, runs, *best)) : "none");
  }
  return text + cheapest_of_families(chart, runs, measurement);
}

/// "1.96 (2 by theory)", or what stands in its way.
std::string order_text(const std::vector<double>& size, const std::vector<double>& error,
                       std::optional<double> theory) {
  if (size.size() < 2) return "not studied";
  const Order order = order_of(size, error);
  std::string text = std::isfinite(order.order) ? fmt::format("{:.2f}", order.order) : "none";
  if (theory) text += fmt::format(" ({:.3g} by theory)", *theory);
  if (!order.asymptotic) return text + ", no asymptotic range";
  return order.first > 0 ? text + fmt::format(", from run {} on", order.first + 1) : text;
}

/// Says the same for steps, by their means: those that a limit cuts do not grow shorter.
std::string steps_text(const std::vector<double>& size, const std::vector<double>& value, double answer,
                       std::optional<double> theory) {
  if (size.empty()) return "not studied";
  if (!std::ranges::all_of(value, [](double each) { return std::isfinite(each); })) return "not all runs end well";
  if (std::ranges::adjacent_find(size, [](double a, double b) { return !(b < 0.99 * a); }) != size.end())
    return "a limit cuts the steps: they do not all grow shorter";
  if (size.size() < 3) return "three steps at least show an order";
  if (!std::isfinite(answer)) return "no answer to set it against";
  const auto errors = errors_of_steps(size, value, answer);
  if (std::isnan(errors.front())) return "values do not converge with the step";
  return order_text(size, errors, theory) + fmt::format(", {} by the longest step", percent(errors.front()));
}

std::string orders_text(const Chart& chart, const std::vector<ChartRun>& runs, const Measurement& measurement) {
  std::string text = "\norders of the error in cells; in steps, of what is the step's part of it\n";
  for (std::size_t f = 0; f < chart.families.size(); ++f) {
    const Family& family = chart.families[f];
    const auto cells = numbers_of(runs, measurement, f, Of::cells, &Measured::error);
    const auto values = numbers_of(runs, measurement, f, Of::steps, &Measured::value);
    const auto sizes = numbers_of(runs, measurement, f, Of::steps, &Measured::step);
    text += fmt::format("  {}: {}; {}\n", family.name, order_text(family.cells.size, cells, family.space_order),
                        steps_text(sizes, values, measurement.answer, family.step_order));
  }
  return text;
}

/// Says what is as accurate as the published run itself, on finer meshes, too, and cheaper.
std::string setting_text(const Chart& chart, const std::vector<ChartRun>& runs, const Measurement& measurement) {
  if (!chart.setting) return "";
  std::size_t k = 0;
  while (runs[k].family != (*chart.setting)[0] || runs[k].of != Of::cells || runs[k].rung != (*chart.setting)[1]) ++k;
  const Measured& published = measurement.runs[k];
  std::string text = fmt::format("\npublished setting: {}, error {}, lasting {}, {:.4g} s\n", name_of(chart, runs, k),
                                 percent(published.error), percent(published.lasting), published.seconds);
  if (!std::isfinite(published.error)) return text + "  it has no error to compare with\n";
  const auto best = cheapest(points_of(measurement, &Measured::seconds), published.error);
  const double factor = best ? published.seconds / measurement.runs[*best].seconds : 0;
  if (factor < least_factor) return text + "  none that is as accurate is 1.2 times cheaper\n";
  return text + fmt::format("  {:.3g} times cheaper, lasting error {}: {}\n", factor,
                            percent(measurement.runs[*best].lasting), name_of(chart, runs, *best));
}

}  // namespace

std::string report_text(const Chart& chart, const std::vector<ChartRun>& runs, const Measurement& measurement) {
  return answer_text(chart, measurement) + front_text(chart, runs, measurement, "seconds", &Measured::seconds, "s") +
         front_text(chart, runs, measurement, "memory", &Measured::megabytes, "MB") +
         cheapest_text(chart, runs, measurement) + orders_text(chart, runs, measurement) +
         setting_text(chart, runs, measurement);
}

}  // namespace tether::chart
