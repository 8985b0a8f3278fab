// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <array>
#include <cmath>
#include <string>

#include "studies/chart/chart_runs.hpp"

namespace tether::chart {
namespace {

constexpr std::array tolerances{0.1, 0.03, 0.01, 0.003, 0.001};

std::string percent(double part) { return std::isfinite(part) ? fmt::format("{:.3g} %", 100 * part) : "-"; }

/// "family, overrides" of a run.
std::string name_of(const Chart& chart, const ChartRun& run) {
  const Family& family = chart.families[run.family];
  const std::size_t own = chart.study.sets.size() + family.sets.size();
  return fmt::format("{}: {}", family.name,
                     fmt::join(run.study.sets.begin() + static_cast<std::ptrdiff_t>(own), run.study.sets.end(), " "));
}

std::vector<Point> points_of(const Measurement& measurement, double Measured::*cost) {
  std::vector<Point> points;
  for (const Measured& run : measurement.runs) points.push_back({run.*cost, run.lasting});
  return points;
}

std::string answer_text(const Chart& chart, const Measurement& measurement) {
  if (!std::isfinite(measurement.answer))
    return "no answer: no run shows the exact one, or no family's runs converge\n";
  if (chart.exact) return fmt::format("answer {:.8g}, exact\n", measurement.answer);
  return fmt::format("answer {:.8g} +- {:.2g}, converged: what the cells of {} lead to, by Richardson\n",
                     measurement.answer, measurement.bound, chart.families[measurement.answered_by].name);
}

std::string front_text(const Chart& chart, const std::vector<ChartRun>& runs, const Measurement& measurement,
                       const char* of, double Measured::*cost, const char* unit) {
  std::string text = fmt::format("\nno run beats these in lasting error and {}:\n", of);
  const auto points = points_of(measurement, cost);
  for (const std::size_t k : front(points))
    text += fmt::format("  {:>10} {:>10.4g} {}  {}\n", percent(points[k].error), points[k].cost, unit,
                        name_of(chart, runs[k]));
  return text;
}

std::string cheapest_text(const Chart& chart, const std::vector<ChartRun>& runs, const Measurement& measurement) {
  std::string text = "\nthe cheapest choice for a lasting error of\n";
  const auto points = points_of(measurement, &Measured::seconds);
  for (const double tolerance : tolerances) {
    const auto best = cheapest(points, tolerance);
    text += fmt::format("  {:>6}  {}\n", percent(tolerance),
                        best ? fmt::format("{:.4g} s  {}", points[*best].cost, name_of(chart, runs[*best])) : "none");
  }
  return text;
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

std::string orders_text(const Chart& chart, const std::vector<ChartRun>& runs, const Measurement& measurement) {
  std::string text = "\norders of the error in cells; in steps, of what is the step's part of it\n";
  for (std::size_t f = 0; f < chart.families.size(); ++f) {
    const Family& family = chart.families[f];
    const auto cells = numbers_of(runs, measurement, f, Of::cells, &Measured::error);
    const auto values = numbers_of(runs, measurement, f, Of::steps, &Measured::value);
    const auto steps = errors_of_steps(family.steps.size, values, measurement.answer);
    text += fmt::format("  {}: {}; {}{}\n", family.name, order_text(family.cells.size, cells, family.space_order),
                        order_text(family.steps.size, steps, family.step_order),
                        steps.empty() ? "" : fmt::format(", {} by the longest step", percent(steps.front())));
  }
  return text;
}

/// What is as accurate as the published setting and cheaper.
std::string setting_text(const Chart& chart, const std::vector<ChartRun>& runs, const Measurement& measurement) {
  if (!chart.setting) return "";
  std::size_t k = 0;
  while (runs[k].family != (*chart.setting)[0] || runs[k].of != Of::cells || runs[k].rung != (*chart.setting)[1]) ++k;
  const Measured& published = measurement.runs[k];
  std::string text = fmt::format("\npublished setting: {}, error {}, {:.4g} s\n", name_of(chart, runs[k]),
                                 percent(published.lasting), published.seconds);
  const auto best = cheapest(points_of(measurement, &Measured::seconds), published.lasting);
  if (!best || *best == k) return text + "  no cheaper one is as accurate\n";
  const Measured& found = measurement.runs[*best];
  return text + fmt::format("  {:.3g} times cheaper, error {}: {}\n", published.seconds / found.seconds,
                            percent(found.lasting), name_of(chart, runs[*best]));
}

}  // namespace

std::string report_text(const Chart& chart, const std::vector<ChartRun>& runs, const Measurement& measurement) {
  return answer_text(chart, measurement) + front_text(chart, runs, measurement, "seconds", &Measured::seconds, "s") +
         front_text(chart, runs, measurement, "memory", &Measured::megabytes, "MB") +
         cheapest_text(chart, runs, measurement) + orders_text(chart, runs, measurement) +
         setting_text(chart, runs, measurement);
}

}  // namespace tether::chart
