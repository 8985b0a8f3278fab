// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/chart/read_chart.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "base/diagnostics.hpp"
#include "base/process.hpp"
#include "studies/chart/chart_runs.hpp"
#include "studies/combinations.hpp"
#include "studies/read_study.hpp"
#include "studies/reading_checks.hpp"
#include "studies/study_checks.hpp"

namespace tether::chart {
namespace {

constexpr const char* converged = "converged";

/// Relative size of a cell or a step from the first value that a ladder's run has.
double size_of(const Assignment& assignment, double value) {
  const bool nodes = assignment.name == "nx" || assignment.name == "ny" || assignment.name == "nz";
  const bool counts = AnyVariable(assignment.group, assignment.name).row().type == ValueType::integer;
  return nodes ? 1 / (value - 1) : counts ? 1 / value : value;
}

/// Takes families and answer out of a chart deck; every mistake becomes a remark at its place.
class ChartReader {
 public:
  ChartReader(const Deck& deck, Diagnostics& diagnostics)
      : deck_(deck), diagnostics_(diagnostics), remarks_(deck, diagnostics) {}

  Chart read() {
    chart_.study = study_of(deck_, diagnostics_);
    if (chart_.study.mode != Mode::chart) {
      remarks_.error("study.mode", 1, "this study is no chart", "mode='chart' makes it one; tether sweep runs others");
      return std::move(chart_);
    }
    for (const auto& at : deck_.given_elements("study.family")) read_family(at[0]);
    for (const AnyVariable name : Variables{"study.family_set", "study.cells", "study.steps"}) tell_of_orphans(name);
    if (deck_.given("study.setting", 1)) read_setting();
    if (deck_.given("study.answer_by")) read_answer_by();
    if (!diagnostics_.has_errors()) check_runs();
    if (diagnostics_.has_errors() && written_.columns.empty()) return std::move(chart_);  // names cannot be judged
    chart_.value = checked_reading(deck_, "study.is", written_, remarks_);
    if (deck_.text("study.exact") != converged)
      chart_.exact = checked_reading(deck_, "study.exact", written_, remarks_);
    return std::move(chart_);
  }

 private:
  void read_family(int k) {
    Family family{.name = deck_.text("study.family", k),
                  .deck = deck_of(k),
                  .space_order = order("study.space_order", k),
                  .step_order = order("study.step_order", k)};
    numbers_[k] = chart_.families.size();
    if (!names_.insert(family.name).second)
      remarks_.error("study.family", k, fmt::format("two families are called '{}'", family.name));
    owners_ = owners_of_sets();
    for (const auto& at : deck_.given_elements("study.family_set")) {
      if (at[1] == k) read_set(at, family);
    }
    const auto set = owners_;
    family.cells = ladder("study.cells", k);
    owners_ = set;  // a step that goes with the cells has another value where steps are studied
    family.steps = ladder("study.steps", k);
    if (family.cells.size.empty() && !diagnostics_.has_errors())
      remarks_.error("study.family", k, fmt::format("family {} has no cells", k),
                     fmt::format("cells(1,{})='in.nx=9,17,33'", k));
    chart_.families.push_back(std::move(family));
  }

  /// The elements that all runs' values set.
  std::map<std::string, std::string> owners_of_sets() const {
    std::map<std::string, std::string> owners;
    for (const auto& at : deck_.given_elements("study.set")) {
      const Assignment assignment = read_assignment(deck_.text("study.set", at[0]), Taken::together);
      for (const auto& element : assignment.all) owners.try_emplace(element, fmt::format("set({})", at[0]));
    }
    return owners;
  }

  /// decks(family_deck(k)), by its place among those that are given.
  std::size_t deck_of(int k) {
    const int number = deck_.integer("study.family_deck", k);
    const auto& decks = chart_.study.decks;
    const auto found =
        std::find_if(decks.begin(), decks.end(), [&](const BaseDeck& deck) { return deck.number == number; });
    if (found != decks.end()) return static_cast<std::size_t>(found - decks.begin());
    if (!decks.empty())
      remarks_.error("study.family_deck", k, fmt::format("there is no deck {}", number), "decks names it");
    return 0;
  }

  std::optional<double> order(RealVariable name, int k) const {
    return deck_.given(name, k) ? std::optional(deck_.real(name, k)) : std::nullopt;
  }

  void read_set(Subscript at, Family& family) {
    const std::string text = deck_.text("study.family_set", at[0], at[1]);
    const Assignment assignment = read_assignment(text, Taken::together);
    remarks_.tell("study.family_set", at, assignment.mistakes);
    if (!assignment.mistakes.empty()) return;
    own("study.family_set", at, assignment.all);
    family.sets.push_back(text);
  }

  Ladder ladder(TextVariable name, int k) {
    Ladder ladder;
    for (const auto& at : deck_.given_elements(name)) {
      if (at[1] != k) continue;
      const Assignment assignment = read_assignment(deck_.text(name, at[0], at[1]), Taken::one_by_one);
      remarks_.tell(name, at, assignment.mistakes);
      if (!assignment.mistakes.empty()) continue;
      own(name, at, assignment.one_value);
      if (ladder.size.empty())
        begin(name, at, assignment, ladder);
      else if (assignment.values.size() != ladder.size.size())
        remarks_.error(name, at,
                       fmt::format("it has {} values, the first of family {} has {}", assignment.values.size(), k,
                                   ladder.size.size()),
                       "values that move together are equally many");
      for (std::size_t v = 0; v < std::min(ladder.overrides.size(), assignment.values.size()); ++v)
        ladder.overrides[v].push_back(assignment.override_text(v));
    }
    return ladder;
  }

  void begin(TextVariable name, Subscript at, const Assignment& assignment, Ladder& ladder) {
    ladder.overrides.resize(assignment.values.size());
    for (std::size_t v = 0; v < assignment.values.size(); ++v) {
      const Cell cell = assignment.cell(v);
      const double size = std::holds_alternative<double>(cell) ? size_of(assignment, std::get<double>(cell)) : 0;
      if (!(size > 0) || (v > 0 && size >= ladder.size.back()))
        return remarks_.error(name, at, fmt::format("{} does not make the runs finer", assignment.values[v]),
                              "numbers, the coarsest run's first");
      ladder.size.push_back(size);
    }
  }

  /// No two values of a family may set one element.
  void own(AnyVariable name, Subscript at, const std::set<std::string>& elements) {
    for (const auto& element : elements) {
      const auto [owner, fresh] = owners_.try_emplace(element, fmt::format("{}({},{})", name.name(), at[0], at[1]));
      if (!fresh) return remarks_.error(name, at, fmt::format("{} is set by {}, too", element, owner->second));
    }
  }

  void tell_of_orphans(AnyVariable name) {
    for (const auto& at : deck_.given_elements(name)) {
      if (numbers_.count(at[1]) == 0)
        remarks_.error(name, at, fmt::format("there is no family {}", at[1]), "family names it");
    }
  }

  void read_answer_by() {
    const auto found = numbers_.find(deck_.integer("study.answer_by"));
    if (found == numbers_.end())
      return remarks_.error("study.answer_by", 1, "there is no such family", "family names it");
    if (deck_.text("study.exact") != converged)
      remarks_.error("study.answer_by", 1, "the answer is given: no family is asked for it", "exact='converged'");
    chart_.answered_by = found->second;
  }

  void read_setting() {
    const auto found = numbers_.find(deck_.integer("study.setting", 1));
    const std::size_t runs = found == numbers_.end() ? 0 : chart_.families[found->second].cells.size.size();
    const int run = deck_.given("study.setting", 2) ? deck_.integer("study.setting", 2) : 0;
    if (run < 1 || static_cast<std::size_t>(run) > runs)
      return remarks_.error("study.setting", 1, "there is no such run", "setting=2,3 is run 3 of family 2's cells");
    chart_.setting = {found->second, static_cast<std::size_t>(run - 1)};
  }

  /// Each run's scene is built; a family's mistakes are those of its first run that has some.
  void check_runs() {
    std::set<std::size_t> told;
    for (const ChartRun& run : runs_of(chart_)) {
      if (told.count(run.family) > 0) continue;
      const bool is_first = run.rung == 0 && run.of == Of::cells;
      const Ending ending = try_scene(chart_.study.file, read_deck(run.study, {0, {}}), is_first ? &written_ : nullptr);
      if (ending.exit_code == exit_done) continue;
      told.insert(run.family);
      remarks_.error("study.family", number_of(run.family),
                     fmt::format("family {} cannot be run:\n{}", number_of(run.family), ending.message),
                     fmt::format("{}", fmt::join(run.study.sets, " ")));
    }
  }

  int number_of(std::size_t family) const {
    for (const auto& [number, place] : numbers_) {
      if (place == family) return number;
    }
    return 1;
  }

  const Deck& deck_;
  Diagnostics& diagnostics_;
  StudyRemarks remarks_;
  Chart chart_;
  Written written_;                     // by a run of each family
  std::map<int, std::size_t> numbers_;  // family(k) -> its place among the families
  std::set<std::string> names_;
  std::map<std::string, std::string> owners_;  // of the elements that a family sets
};

}  // namespace

Chart read_chart(const std::string& file) {
  Diagnostics diagnostics;
  const Deck deck = read_study_deck(file, diagnostics);
  Chart chart = ChartReader(deck, diagnostics).read();
  diagnostics.throw_if_errors();
  return chart;
}

}  // namespace tether::chart
