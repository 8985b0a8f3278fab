// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/study_checks.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <optional>

#include "base/process.hpp"
#include "deck/reader.hpp"
#include "plan/load.hpp"
#include "read/reference/reference.hpp"
#include "results/summary_keys.hpp"
#include "run/make.hpp"
#include "studies/combinations.hpp"
#include "studies/history_value.hpp"
#include "studies/run_table.hpp"

namespace tether {
namespace {

/// An axis may have thousands of values on a line: it is not shown.
constexpr std::size_t longest_shown_line = 1000;

}  // namespace

void StudyRemarks::error(AnyVariable name, Subscript at, const std::string& message, const std::string& hint) {
  add(deck_.remark(Severity::error, name, at, message, hint));
}

void StudyRemarks::tell(TextVariable name, Subscript at, const std::vector<Mistake>& mistakes) {
  const std::string text = deck_.text(name, at[0], at[1]);
  for (const auto& mistake : mistakes) {
    auto remark = deck_.remark(Severity::error, name, at, mistake.message, mistake.hint);
    const auto quote = static_cast<std::size_t>(remark.place.column);  // the text begins after it
    const bool as_written = remark.line_text.compare(std::min(quote, remark.line_text.size()), text.size(), text) == 0;
    if (as_written) remark.place.column += mistake.column;
    add(std::move(remark));
  }
}

void StudyRemarks::add(Diagnostic remark) {
  if (remark.line_text.size() > longest_shown_line) remark.line_text.clear();
  diagnostics_.add(std::move(remark));
}

namespace {

constexpr unsigned bit(Mode mode) { return 1U << static_cast<unsigned>(mode); }
constexpr unsigned grid = bit(Mode::grid), ensemble = bit(Mode::ensemble), bisect = bit(Mode::bisect),
                   chart = bit(Mode::chart), a_map = bit(Mode::map);

/// For which modes a variable of $study is, and which of them need it.
struct Rule {
  AnyVariable name;
  unsigned modes;
  unsigned needed_by = 0;
  bool is_for(Mode mode) const { return (modes & bit(mode)) != 0; }
  bool is_needed_by(Mode mode) const { return (needed_by & bit(mode)) != 0; }
};

constexpr std::array rules{
    Rule{"study.axis", grid | ensemble | bisect | a_map},
    Rule{"study.linked", grid | ensemble | bisect | a_map},
    Rule{"study.order", grid},
    Rule{"study.quantities", grid | ensemble, grid | ensemble},
    Rule{"study.vary", ensemble | bisect | a_map, ensemble | bisect},
    Rule{"study.fraction", ensemble, ensemble},
    Rule{"study.runs", ensemble, ensemble},
    Rule{"study.low", bisect | a_map, bisect},
    Rule{"study.high", bisect | a_map, bisect},
    Rule{"study.tolerance", bisect | a_map},
    Rule{"study.criterion", bisect | a_map, bisect | a_map},
    Rule{"study.at_least", bisect | a_map},
    Rule{"study.at_most", bisect | a_map},
    Rule{"study.coarse", a_map},
    Rule{"study.theory", a_map},
    Rule{"study.is", chart, chart},
    Rule{"study.exact", chart, chart},
    Rule{"study.family", chart, chart},
    Rule{"study.family_set", chart},
    Rule{"study.family_deck", chart},
    Rule{"study.cells", chart, chart},
    Rule{"study.steps", chart},
    Rule{"study.space_order", chart},
    Rule{"study.step_order", chart},
    Rule{"study.setting", chart},
    Rule{"study.answer_by", chart},
};

/// Keys of summary.txt that are numbers of the run itself; the table has the cost of the whole process anyhow.
bool is_quantity(const std::string& key) { return key != "path" && key != "cpu_seconds" && key != "wall_seconds"; }

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The quantities that some run of the study can write.
class Keys {
 public:
  void add_figures(const std::string& solution) { add(figure_keys(reference_kind(solution))); }
  void add_runs(const Deck& deck) {
    using namespace runs_of;
    const bool mesh = deck.has_group("mesh"), box = deck.has_group("coupled");
    const bool by_points = (!mesh && !box) || deck.given("in.path");
    add(summary_keys((by_points ? points | bars : 0) | (mesh ? meshes : 0) | (box ? boxes : 0)));
  }
  const std::vector<std::string>& known() const { return known_; }

 private:
  void add(std::vector<std::string> keys) {
    for (auto& key : keys) {
      if (is_quantity(key) && !contains(known_, key)) known_.push_back(std::move(key));
    }
  }
  std::vector<std::string> known_;
};

/// Guesses what a user may have meant by a key that no run writes; a column of the history wants a function.
std::string meant_key(const std::string& key, const std::vector<std::string>& known) {
  return meant(key, known) + " Of a column of history.txt: last(body_vx_1), say.";
}

bool is_of_history(const Study& study, const std::string& key) {
  const auto named = [&](const WantedValue& wanted) { return wanted.value.name() == key; };
  return std::any_of(study.history_values.begin(), study.history_values.end(), named);
}

void check_quantities(const Deck& deck, const Study& study, const std::vector<std::string>& known,
                      StudyRemarks& remarks) {
  const auto given = deck.given_elements("study.quantities");
  std::vector<std::string> before;
  for (std::size_t k = 0; k < given.size(); ++k) {
    const std::string key = study.quantities[k];
    if (key.empty()) continue;  // reported
    if (contains(fixed_columns(), key))
      remarks.error("study.quantities", given[k][0], fmt::format("every table has {}", key), "Leave it out.");
    else if (!contains(known, key) && !is_of_history(study, key))
      remarks.error("study.quantities", given[k][0], fmt::format("no run writes {} into its summary", key),
                    meant_key(key, known));
    else if (contains(before, key))
      remarks.error("study.quantities", given[k][0], fmt::format("{} stands there twice", key));
    before.push_back(key);
  }
}

void check_criterion(const Study& study, std::vector<std::string> known, StudyRemarks& remarks) {
  known.insert(known.begin(), exit_code_key);
  const std::string& key = study.criterion.key;
  if (key.empty() || contains(known, key) || is_of_history(study, key)) return;
  remarks.error("study.criterion", 1, fmt::format("no run writes {} into its summary", key), meant_key(key, known));
}

void check_order(const Study& study, const std::vector<std::string>& known, StudyRemarks& remarks) {
  if (study.order.empty()) return;
  std::vector<std::string> columns = study.quantities;
  for (const StudyAxis& axis : study.axes) {
    if (std::holds_alternative<double>(axis.cells.front())) columns.push_back(axis.variable);
  }
  if (study.axes.empty()) remarks.error("study.order", 1, "an order is reported along axis 1, and there is none");
  if (contains(columns, study.order)) return;
  const bool could_be = contains(known, study.order);
  remarks.error("study.order", 1, fmt::format("the table has no column {} of numbers", study.order),
                could_be ? fmt::format("Add '{}' to quantities.", study.order) : meant(study.order, columns));
}

/// Reads a base deck with the values of its first combination.
Deck read_base(const Study& study, std::size_t k, Diagnostics& diagnostics) {
  const Combination first{k, std::vector<std::size_t>(study.axes.size(), 0)};
  return read_deck(study.decks[k].text, study.decks[k].file, overrides_of(study, first, {}), diagnostics);
}

/// Its mistakes; those of overrides were reported at the study's axes and sets.
void tell_of(const Deck& deck, int number, const Diagnostics& found, StudyRemarks& remarks, Diagnostics& diagnostics) {
  if (deck.is_study()) return remarks.error("study.decks", number, "this deck is a study itself");
  for (const auto& error : found.errors()) {
    if (error.place.file != override_file) diagnostics.add(error);
  }
}

}  // namespace

void check_mode(const Deck& deck, Mode mode, StudyRemarks& remarks) {
  const std::string word = deck.text("study.mode");
  for (const Rule& rule : rules) {
    const bool given = !deck.given_elements(rule.name).empty();
    if (given && !rule.is_for(mode)) {
      remarks.error(rule.name, 1, fmt::format("{} is not for mode '{}'", rule.name, word));
    } else if (!given && rule.is_needed_by(mode)) {
      remarks.error("study.mode", 1, fmt::format("a study of mode '{}' needs {}", word, rule.name));
    }
  }
}

void check_decks(const Deck& deck, const Study& study, StudyRemarks& remarks, Diagnostics& diagnostics) {
  Keys keys;
  for (std::size_t k = 0; k < study.decks.size(); ++k) {
    Diagnostics found;
    const Deck base = read_base(study, k, found);
    tell_of(base, study.decks[k].number, found, remarks, diagnostics);
    keys.add_runs(base), keys.add_figures(base.text("reference.solution"));
  }
  for (const StudyAxis& axis : study.axes) {
    if (axis.variable != "reference.solution") continue;
    for (const Cell& cell : axis.cells) keys.add_figures(std::get<std::string>(cell));
  }
  if (study.decks.empty()) return;  // reported; nothing can be known of keys
  check_quantities(deck, study, keys.known(), remarks);
  if (study.mode == Mode::bisect || study.mode == Mode::map) check_criterion(study, keys.known(), remarks);
  check_order(study, keys.known(), remarks);
}

namespace {

using Names = std::vector<std::string>;

/// Scenes that are built at most: a mistake is worth some seconds.
constexpr std::size_t most_scenes = 400;

/// All combinations where they are few; else each value of each axis, of each deck, with the other axes at their first
/// or at their last values: a column that none of these writes is none that another one would.
std::vector<Combination> told_apart(const Study& study) {
  constexpr double few = 100;
  if (count_combinations(study) <= few) return combinations(study);
  std::vector<Combination> some;
  for (std::size_t d = 0; d < study.decks.size(); ++d) {
    for (const std::size_t axis : leading_axes(study)) {
      for (std::size_t v = 0; v < study.axes[axis].cells.size(); ++v) {
        for (const bool others_last : {false, true}) some.push_back(on_edge(study, d, axis, v, others_last));
      }
    }
  }
  return some;
}

/// The columns of a run's history, before it is run; nothing where its scene cannot be built, which the run will
/// report.
std::optional<Names> columns_of(const Study& study, const Combination& combination) {
  Names columns;
  const Ending ending = end_of(study.file, [&] {
    Diagnostics of_the_run;
    const Loaded loaded = load_scene(read_deck(study, combination), {}, of_the_run);
    columns = make_solver(loaded.plan)->history_layout().column_names();
  });
  if (ending.exit_code != exit_done) return std::nullopt;
  return columns;
}

}  // namespace

void check_columns(const Study& study, StudyRemarks& remarks) {
  auto open = study.history_values;
  const auto some = told_apart(study);
  bool all_known = some.size() <= most_scenes;
  Names seen;
  for (std::size_t c = 0; c < std::min(some.size(), most_scenes) && !open.empty(); ++c) {
    const auto columns = columns_of(study, some[c]);
    all_known = all_known && columns.has_value();
    for (const auto& name : columns.value_or(Names{})) {
      if (!contains(seen, name)) seen.push_back(name);
    }
    std::erase_if(open, [&](const WantedValue& wanted) { return contains(seen, wanted.value.column); });
  }
  if (!all_known) return;
  for (const auto& [value, variable, number] : open) {
    const auto message = fmt::format("no run's history.txt has a column '{}'", value.column);
    remarks.tell(variable, number, {{value.at, message, meant(value.column, seen)}});
  }
}

}  // namespace tether
