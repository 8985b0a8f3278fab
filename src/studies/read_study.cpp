// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/read_study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "base/process.hpp"
#include "deck/reader.hpp"
#include "read/values.hpp"
#include "studies/combinations.hpp"
#include "studies/study_checks.hpp"

namespace tether {
namespace {

namespace fs = std::filesystem;

/// More runs than this were never meant.
constexpr double most_runs = 100000;

/// Takes the study out of its deck; every mistake becomes a remark at its place.
class StudyReader {
 public:
  StudyReader(const Deck& deck, Diagnostics& diagnostics)
      : deck_(deck), diagnostics_(diagnostics), remarks_(deck, diagnostics) {}

  Study read() {
    study_.file = deck_.file();
    study_.text = deck_.text();
    study_.title = fmt::format("{}", fmt::join(deck_.header(), "\n"));
    study_.mode = *find_word<Mode>(text("study.mode"));
    if (!diagnostics_.has_errors()) check_mode(deck_, study_.mode, remarks_);  // what was not read is not missing
    read_decks();
    for (const auto& at : given("study.set")) read_set(at[0]);
    for (const auto& at : given("study.axis")) read_axis(at[0]);
    for (const auto& at : given("study.linked")) link(at[0]);
    for (const auto& at : given("study.quantities")) study_.quantities.push_back(quantity("study.quantities", at[0]));
    study_.order = text("study.order");
    if (study_.mode != Mode::grid && study_.mode != Mode::chart && is_given("study.vary")) read_vary();
    if (study_.mode == Mode::ensemble) read_ensemble();
    if (study_.mode == Mode::bisect || study_.mode == Mode::map) read_criterion();
    if (study_.bisects()) read_interval();
    if (study_.mode == Mode::map) study_.coarse = static_cast<std::size_t>(deck_.integer("study.coarse"));
    check_decks(deck_, study_, remarks_, diagnostics_);
    if (check_number_of_runs() && study_.mode == Mode::ensemble) find_own_values();
    if (!diagnostics_.has_errors()) check_columns(study_, remarks_);
    return std::move(study_);
  }

 private:
  std::vector<Subscript> given(AnyVariable name) const { return deck_.given_elements(name); }
  bool is_given(AnyVariable name) const { return deck_.given(name); }
  std::string text(TextVariable name, int k = 1) const { return deck_.text(name, k); }
  double number(RealVariable name) const { return deck_.real(name); }

  void read_decks() {
    if (given("study.decks").empty()) remarks_.error("study.decks", 1, "the study names no deck", "decks='../sod.in'");
    for (const auto& at : given("study.decks")) {
      const std::string name = text("study.decks", at[0]), mistake = path_mistake(name);
      if (!mistake.empty()) {
        remarks_.error("study.decks", at[0], "the deck's path " + mistake,
                       "write a path from the study deck's folder, at most one folder up");
        continue;
      }
      const std::string file = (fs::path(deck_.file()).parent_path() / name).lexically_normal().string();
      const auto same = [&](const BaseDeck& other) { return other.file == file; };
      if (std::any_of(study_.decks.begin(), study_.decks.end(), same))
        remarks_.error("study.decks", at[0], "this deck stands there twice");
      try {
        study_.decks.push_back({at[0], file, read_file(file)});
      } catch (const FileError& error) {
        remarks_.error("study.decks", at[0], error.what(), "the path counts from the study deck's folder");
      }
    }
  }

  void read_set(int k) {
    const std::string value = text("study.set", k);
    const Assignment assignment = read_assignment(value, Taken::together);
    remarks_.tell("study.set", k, assignment.mistakes);
    if (!assignment.mistakes.empty()) return;
    own("study.set", k, assignment.all);
    study_.sets.push_back(value);
  }

  void read_axis(int k) {
    const Assignment assignment = read_assignment(text("study.axis", k), Taken::one_by_one);
    remarks_.tell("study.axis", k, assignment.mistakes);
    if (!assignment.mistakes.empty()) return;
    own("study.axis", k, assignment.one_value);
    StudyAxis axis{assignment.variable, {}, {}, study_.axes.size()};
    for (std::size_t v = 0; v < assignment.values.size(); ++v) {
      axis.overrides.push_back(assignment.override_text(v));
      axis.cells.push_back(assignment.cell(v));
    }
    if (deck_.integer("study.linked", k) == 0) tell_of_doubles(k, axis, assignment.values);
    numbers_[k] = study_.axes.size();
    study_.axes.push_back(std::move(axis));
  }

  /// Reports doubles of an axis that moves alone: one that follows may well stay where it is.
  void tell_of_doubles(int k, const StudyAxis& axis, const std::vector<std::string>& values) {
    std::set<Cell> seen;
    for (std::size_t v = 0; v < values.size(); ++v) {
      if (!seen.insert(axis.cells[v]).second)
        remarks_.error("study.axis", k, fmt::format("the value {} stands there twice", values[v]));
    }
  }

  void link(int k) {
    const int leader = deck_.integer("study.linked", k);
    if (leader == 0) return;
    if (!deck_.given("study.axis", k) || !deck_.given("study.axis", leader) || leader >= k)
      return remarks_.error("study.linked", k, fmt::format("axis {} cannot move along with axis {}", k, leader),
                            "linked(2)=1 lets axis 2 move along with axis 1: both are there, the lower number leads");
    if (numbers_.count(k) == 0 || numbers_.count(leader) == 0) return;  // reported with its axis
    StudyAxis &axis = study_.axes[numbers_[k]], &first = study_.axes[numbers_[leader]];
    if (axis.cells.size() != first.cells.size()) {
      remarks_.error("study.linked", k,
                     fmt::format("axis {} has {} values, axis {} has {}: axes that move together have equally many", k,
                                 axis.cells.size(), leader, first.cells.size()));
    }
    axis.leader = first.leader;
  }

  /// The column of a quantity; "" where its text is a mistake, which is reported.
  std::string quantity(TextVariable name, int k = 1) {
    std::string as_given = text(name, k);
    if (!is_history_value(as_given)) return as_given;
    const auto [value, mistakes] = read_history_value(as_given);
    remarks_.tell(name, k, mistakes);
    if (!mistakes.empty()) return "";
    study_.history_values.push_back({value, name, k});
    return value.name();
  }

  void read_vary() {
    const Assignment varied = read_assignment(text("study.vary") + "=0.0", Taken::name_alone);
    remarks_.tell("study.vary", 1, varied.mistakes);
    if (!varied.mistakes.empty()) return;
    if (AnyVariable(varied.group, varied.name).row().type != ValueType::real)
      return remarks_.error("study.vary", 1, fmt::format("{} is no real number", varied.variable));
    own("study.vary", 1, varied.one_value);
    study_.vary = {varied.variable, varied.group, varied.name, varied.first};
  }

  void read_ensemble() {
    if (is_given("study.fraction")) study_.fraction = number("study.fraction");
    if (is_given("study.runs")) study_.runs = deck_.integer("study.runs");
  }

  void read_criterion() {
    study_.criterion.key = quantity("study.criterion");
    if (is_given("study.at_least")) study_.criterion.at_least = number("study.at_least");
    if (is_given("study.at_most")) study_.criterion.at_most = number("study.at_most");
    const bool bounded = is_given("study.at_least") || is_given("study.at_most");
    if (!bounded && study_.criterion.key == exit_code_key) study_.criterion.at_most = exit_done;
    if (!bounded && study_.criterion.key != exit_code_key)
      remarks_.error("study.criterion", 1, "the criterion has no bound", "at_most=100.0, or at_least");
    if (study_.criterion.at_least > study_.criterion.at_most)
      remarks_.error("study.at_least", 1, "nothing lies between at_least and at_most");
  }

  void read_interval() {
    if (!is_given("study.low") || !is_given("study.high")) return;
    study_.interval = {number("study.low"), number("study.high"), number("study.tolerance")};
    if (!(study_.interval.low < study_.interval.high))
      remarks_.error("study.high", 1, "a bisection's high is above its low");
    for (const AnyVariable end : Variables{"study.low", "study.high"}) {
      if (!study_.vary.variable.empty()) tell_of_value(end, number(end));
    }
  }

  /// Reports whether the varied variable may have this value.
  void tell_of_value(AnyVariable at, double value) {
    const auto text = fmt::format("{}={}", study_.vary.variable, value);
    for (const auto& mistake : read_assignment(text, Taken::one_by_one).mistakes)
      remarks_.error(at, 1, mistake.message, mistake.hint);
  }

  bool check_number_of_runs() {
    const double count = count_combinations(study_) * (study_.mode == Mode::ensemble ? study_.runs : 1);
    if (count > most_runs)
      remarks_.error("study.axis", 1, fmt::format("the study has {:.3g} runs, more than 100000", count));
    return count <= most_runs;
  }

  /// Finds what the ensemble's value is in each combination; it ends at the first that will not do.
  void find_own_values() {
    for (const Combination& combination : combinations(study_)) {
      if (diagnostics_.has_errors()) return;
      const Deck deck = read_deck(study_, combination);
      const Subscript& at = study_.vary.at;
      const RealVariable name(study_.vary.group, study_.vary.name);
      const bool any = deck.given(name, at[0], at[1]) || !name.row().fallback.empty();
      const double own = any ? deck.real(name, at[0], at[1]) : 0;
      if (own == 0)
        remarks_.error("study.vary", 1,
                       fmt::format("{} is {} in {}: it has no fraction", study_.vary.variable, any ? "0" : "not given",
                                   study_.decks[combination.deck].file));
      for (const double end : {1 - study_.fraction, 1 + study_.fraction}) tell_of_value("study.fraction", own * end);
      study_.own_values.push_back(own);
    }
  }

  /// Notes the elements of the decks that something sets; no two may set one.
  void own(AnyVariable name, int k, const std::set<std::string>& elements) {
    for (const auto& element : elements) {
      const auto [owner, fresh] = owners_.try_emplace(element, fmt::format("{}({})", name, k));
      if (!fresh) return remarks_.error(name, k, fmt::format("{} is set by {}, too", element, owner->second));
    }
  }

  const Deck& deck_;
  Diagnostics& diagnostics_;
  StudyRemarks remarks_;
  Study study_;
  std::map<int, std::size_t> numbers_;  // axis(k) -> its place in study_.axes
  std::map<std::string, std::string> owners_;
};

}  // namespace

Deck read_study_deck(const std::string& file, Diagnostics& diagnostics) {
  Deck deck = read_deck(read_file(file), file, {}, diagnostics);
  if (!deck.is_study()) {
    diagnostics.error({file, 0, 0}, "", "there is no group $study", "A deck that is no study is run by: tether DECK");
    diagnostics.throw_if_errors();
  }
  return deck;
}

Study study_of(const Deck& deck, Diagnostics& diagnostics) { return StudyReader(deck, diagnostics).read(); }

Study read_study(const std::string& file) {
  Diagnostics diagnostics;
  const Deck deck = read_study_deck(file, diagnostics);
  Study study = study_of(deck, diagnostics);
  if (study.mode == Mode::chart)
    StudyRemarks(deck, diagnostics).error("study.mode", 1, "this study is a chart", "tether chart makes it");
  if (study.mode == Mode::map)
    StudyRemarks(deck, diagnostics).error("study.mode", 1, "this study is a map", "tether map makes it");
  diagnostics.throw_if_errors();
  return study;
}

}  // namespace tether
