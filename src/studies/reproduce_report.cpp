// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>

#include "base/version.hpp"
#include "studies/table.hpp"

namespace tether::published {
namespace {

using Texts = std::vector<std::string>;

/// The columns of either table.
struct ReportColumn {
  const char* name;
  std::string ReportRow::*text;
};
constexpr std::array columns{
    ReportColumn{"problem", &ReportRow::problem},      ReportColumn{"quantity", &ReportRow::quantity},
    ReportColumn{"thesis method", &ReportRow::thesis}, ReportColumn{"robust", &ReportRow::robust},
    ReportColumn{"published", &ReportRow::published},  ReportColumn{"exact", &ReportRow::exact},
    ReportColumn{"verdict", &ReportRow::verdict}};

/// Spread over median below which runs agree to rounding: what they begin with does.
constexpr double same = 1e-12;

/// Five digits, and all of a whole number's.
std::string number_text(double value) {
  return std::abs(value) < 1e5 || std::abs(value) >= 1e9 ? fmt::format("{:.5g}", value) : fmt::format("{:.0f}", value);
}

std::string verdict_text(const MethodResult& thesis, const Verdict& of_thesis, const MethodResult& robust,
                         const Verdict& of_robust) {
  if (thesis.runs > 0 && robust.runs > 0 && of_thesis.text == of_robust.text) return "both: " + of_thesis.text;
  Texts said;
  if (thesis.runs > 0) said.push_back("thesis: " + of_thesis.text);
  if (robust.runs > 0) said.push_back("robust: " + of_robust.text);
  return fmt::format("{}", fmt::join(said, "; "));
}

std::string overrides_text(const MethodRuns& method) {
  auto overrides = method.overrides;
  if (method.varied) {
    overrides.push_back(fmt::format("the step varied by up to {} % in {} runs", 100 * varied_fraction, varied_runs));
  }
  return overrides.empty() ? "as it is" : fmt::format("{}", fmt::join(overrides, ", "));
}

/// A cell of Markdown: a bar would end it.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? "\\|" : std::string(1, c);
  return escaped;
}

std::string runs_of(const Problem& problem) {
  const std::string deck = problem.study.empty() ? fmt::format("{}.in", problem.deck)
                                                 : fmt::format("studies/{}.in on {}.in", problem.study, problem.deck);
  const std::string beside = problem.beside.empty() ? "" : fmt::format(", beside {}.in", problem.beside);
  const std::string robust = problem.robust ? overrides_text(*problem.robust) : "not run";
  return fmt::format("| {} | {} | {}{} | {} | {} |\n", problem.name, problem.place, deck, beside,
                     cell(overrides_text(problem.thesis)), cell(robust));
}

}  // namespace

std::string value_text(const Measured& measured) {
  const double median = measured.median();
  if (std::isnan(median)) return "-";
  std::string number = number_text(median);
  if (measured.runs < 2) return number;
  const std::string count = measured.values.size() == measured.runs
                                ? fmt::format("{}", measured.runs)
                                : fmt::format("{} of {}", measured.values.size(), measured.runs);
  if (!(measured.spread() > same * std::abs(median))) return fmt::format("{} ({})", number, count);
  return fmt::format("{} +- {:.2g} ({})", number, measured.spread(), count);
}

std::string published_text(const Quantity& quantity) {
  if (quantity.upper_bound) return fmt::format("< {}", *quantity.upper_bound);
  Texts texts;
  for (const Printed& printed : quantity.published) {
    texts.push_back(
        fmt::format("{}{}", number_text(printed.value), printed.place.empty() ? "" : " (" + printed.place + ")"));
  }
  return texts.empty() ? "-" : fmt::format("{}", fmt::join(texts, " or "));
}

ReportRow report_row(const Problem& problem, const Quantity& quantity, const MethodResult& thesis,
                     const MethodResult& robust) {
  const Measured by_thesis = measure(quantity, thesis), by_robust = measure(quantity, robust);
  Verdict of_thesis, of_robust;
  if (thesis.runs > 0) of_thesis = verdict_on(quantity, by_thesis, quantity.thesis);
  if (robust.runs > 0) of_robust = verdict_on(quantity, by_robust, quantity.robust);
  return {problem.name,
          quantity.name,
          value_text(by_thesis),
          value_text(by_robust),
          published_text(quantity),
          quantity.exact ? number_text(quantity.exact()) : "-",
          verdict_text(thesis, of_thesis, robust, of_robust),
          of_thesis.fails || of_robust.fails};
}

std::string terminal_text(const std::vector<ReportRow>& rows) {
  StudyTable table{"quantity", {}};
  std::vector<std::string> names;
  for (const auto& [name, text] : columns) {
    Texts cells;
    for (const ReportRow& row : rows) cells.push_back(row.*text);
    table.columns.push_back({name, "", "", std::move(cells)});
    names.emplace_back(name);
  }
  return aligned_text(table, names);
}

std::string markdown_text(const std::vector<ReportRow>& rows, const std::vector<Problem>& problems,
                          const std::string& command) {
  std::string text =
      fmt::format("# The published numbers\n\nBy tether {} ({}): `{}`\n\n", program_version(), git_hash(), command);
  std::string rule;
  for (const auto& column : columns) text += fmt::format("| {} ", column.name), rule += "|---";
  text += "|\n" + rule + "|\n";
  for (const ReportRow& row : rows) {
    for (const auto& column : columns) text += fmt::format("| {} ", cell(row.*column.text));
    text += "|\n";
  }
  text +=
      "\nMost tolerances were set about what the runs gave, so they show changes; that a row agrees is no proof of its "
      "own. What a method is known to miss is reported and not judged.\n";
  text += "\n## Their runs\n\n| problem | thesis | deck | overrides, thesis method | overrides, robust method |\n";
  text += "|---|---|---|---|---|\n";
  for (const Problem& problem : problems) text += runs_of(problem);
  return text;
}

}  // namespace tether::published
