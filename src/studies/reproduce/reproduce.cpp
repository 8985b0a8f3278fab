// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/reproduce.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "base/diagnostics.hpp"
#include "base/process.hpp"
#include "results/text_file.hpp"
#include "studies/reproduce/problems.hpp"
#include "studies/sweep.hpp"
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
    ReportColumn{"published", &ReportRow::published},  ReportColumn{"theory", &ReportRow::theory},
    ReportColumn{"exact", &ReportRow::exact},          ReportColumn{"verdict", &ReportRow::verdict}};

/// Spread over median below which runs agree to rounding: what they begin with does.
constexpr double same = 1e-12;

/// Five digits, and all of a whole number's.
std::string number_text(double value) {
  return std::abs(value) < 1e5 || std::abs(value) >= 1e9 ? fmt::format("{:.5g}", value) : fmt::format("{:.0f}", value);
}

std::string printed_text(const Printed& printed) {
  return fmt::format("{}{}", number_text(printed.value), printed.place.empty() ? "" : " (" + printed.place + ")");
}

std::string count_text(const std::vector<ReportRow>& rows) {
  const auto count = [&](Standing standing) {
    return std::count_if(rows.begin(), rows.end(), [&](const ReportRow& row) { return row.standing == standing; });
  };
  return fmt::format("{} rows: {} agree, {} differ, {} are undecided, {} are reported\n", rows.size(),
                     count(Standing::agrees), count(Standing::differs), count(Standing::undecided),
                     count(Standing::reported));
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

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

std::string runs_of(const Problem& problem) {
  const std::string run = file_name(problem.deck);
  const std::string deck = problem.study.empty() ? run : fmt::format("{} on {}", file_name(problem.study), run);
  const std::string reference =
      problem.compared_with.empty() ? "" : fmt::format(", compared with {}", file_name(problem.compared_with));
  const std::string robust = problem.robust ? overrides_text(*problem.robust) : "not run";
  const std::string place =
      problem.source.empty() ? problem.place : fmt::format("{} {}", problem.source, problem.place);
  return fmt::format("| {} | {} | {}{} | {} | {} |\n", problem.name, place, deck, reference,
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

std::string published_text(const PublishedQuantity& quantity) {
  if (quantity.upper_bound) return fmt::format("< {}", *quantity.upper_bound);
  Texts texts;
  for (const Printed& printed : quantity.published) {
    texts.push_back(printed_text(printed));
  }
  return texts.empty() ? "-" : fmt::format("{}", fmt::join(texts, " or "));
}

ReportRow report_row(const Problem& problem, const PublishedQuantity& quantity, const MethodResult& thesis,
                     const MethodResult& robust) {
  const Judgement judgement = judge(quantity, thesis, robust);
  return {.problem = problem.name,
          .quantity = quantity.name,
          .thesis = value_text(measure(quantity, thesis)),
          .robust = value_text(measure(quantity, robust)),
          .published = published_text(quantity),
          .theory = quantity.theory ? printed_text(*quantity.theory) : "-",
          .exact = std::isnan(judgement.exact) ? "-" : number_text(judgement.exact),
          .verdict = judgement.text(problem.by_points ? "thesis" : "run"),
          .standing = judgement.standing()};
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
  return aligned_text(table, names) + count_text(rows);
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
      "\n" + count_text(rows) +
      "\nA printed value's band is half a unit of its last digit, and of chaotic cases the runs' standard deviation "
      "beyond it; runs that spread by more than the digits decide nothing. Exact values are those of the deck that "
      "ran. What one run of the thesis printed and no theory bears out is reported and not judged.\n";
  text += "\n## Their runs\n\n| problem | source | deck | overrides, thesis method | overrides, robust method |\n";
  text += "|---|---|---|---|---|\n";
  for (const Problem& problem : problems) text += runs_of(problem);
  return text;
}

}  // namespace tether::published

namespace tether {
namespace {

namespace fs = std::filesystem;
using published::markdown_text, published::plan_runs, published::problems_named, published::report_row;
using published::MethodResult, published::PlannedRun, published::Problem, published::PublishedQuantity;
using published::ReportRow, published::Role, published::Standing;
using published::terminal_text;

/// Makes the result of a problem by one method. The run that it is compared with belongs to all of the method's runs.
MethodResult result_of(const std::vector<PlannedRun>& runs, const std::vector<RunEnd>& ends, std::size_t problem,
                       Role role, Role reference_role) {
  MethodResult result;
  fs::path reference;
  const auto note = [&result](const Ending& ending) {
    if (ending.exit_code != exit_done && result.failure.empty()) result.failure = ending.message;
    if (ending.exit_code == exit_none) result.is_finished = false;
    return ending.exit_code == exit_done;
  };
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (runs[k].problem == problem && runs[k].role == reference_role && note(ends[k].ending))
      reference = ends[k].folder;
  }
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (runs[k].problem != problem || runs[k].role != role) continue;
    ++result.runs;
    if (fs::exists(ends[k].folder / "deck.effective")) result.begun.emplace_back(ends[k].folder, reference);
    if (note(ends[k].ending)) result.files.emplace_back(ends[k].folder, reference);
  }
  return result;
}

std::vector<ReportRow> rows_of(const std::vector<Problem>& problems, const std::vector<PlannedRun>& runs,
                               const std::vector<RunEnd>& ends) {
  std::vector<ReportRow> rows;
  for (std::size_t k = 0; k < problems.size(); ++k) {
    const auto thesis = result_of(runs, ends, k, Role::thesis, Role::thesis_reference);
    const auto robust = result_of(runs, ends, k, Role::robust, Role::robust_reference);
    std::transform(
        problems[k].quantities.begin(), problems[k].quantities.end(), std::back_inserter(rows),
        [&](const PublishedQuantity& quantity) { return report_row(problems[k], quantity, thesis, robust); });
  }
  return rows;
}

/// An hour's runs are not to be lost to a folder that is not there.
void refuse_lost_file(const fs::path& file) {
  if (file.empty()) return;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::is_directory(folder))
    throw FileError(fmt::format("{}: there is no folder {}", file.string(), folder.string()));
  if (fs::is_directory(file)) throw FileError(fmt::format("{}: is a folder", file.string()));
}

}  // namespace

ReproduceResult reproduce(const std::vector<std::string>& names, const ReproduceOptions& options) {
  const auto problems = problems_named(names, options.decks);
  const auto runs = plan_runs(problems, options.study.out);
  refuse_lost_file(options.write);
  const auto lock = take_folder(options.study, "reproduce");
  const auto ends = run_each({runs.begin(), runs.end()}, options.study);
  const auto rows = rows_of(problems, runs, ends);
  if (!options.write.empty()) replace_file(options.write, markdown_text(rows, problems, options.study.command));
  ReproduceResult result{terminal_text(rows), {}, 0};
  for (const RunEnd& end : ends) {
    result.file_trouble += is_lost(end.ending) ? 1U : 0U;
    result.unfinished += end.ending.exit_code == exit_none ? 1 : 0;
  }
  for (const ReportRow& row : rows) {
    if (row.standing == Standing::differs)
      result.disagreed.push_back(fmt::format("{}, {}: {}", row.problem, row.quantity, row.verdict));
  }
  return result;
}

std::vector<StudyRun> published_runs(const std::vector<std::string>& names, const ReproduceOptions& options) {
  const auto runs = plan_runs(problems_named(names, options.decks), options.study.out);
  return {runs.begin(), runs.end()};
}

}  // namespace tether
