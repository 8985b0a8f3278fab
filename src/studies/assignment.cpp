// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/assignment.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.hpp"
#include "deck/assign.hpp"
#include "deck/elements.hpp"
#include "deck/lexer.hpp"
#include "deck/parser.hpp"
#include "deck/spelling.hpp"

namespace tether {
namespace {

/// Remarks on one text; more would drown its reader.
constexpr std::size_t most_mistakes = 20;

std::string without_blanks(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\t'; });
  return lower(text);
}

std::string spelled(const ItemValue& value) {
  const std::string count = value.counted ? fmt::format("{}*", value.count) : "";
  return count + (value.kind == ItemValue::Kind::quoted ? value_text({value.text, {}}) : value.text);
}

/// A deck that holds this override alone; what the reader says of it goes into `diagnostics`.
Deck deck_of(const std::string& override_text, Diagnostics& diagnostics) {
  Deck::Contents contents;
  contents.overrides = {override_text};
  Remarks remarks(std::string(override_file), contents.overrides, 1, diagnostics);
  Assigner(contents).assign_override(parse_override(lex_override(contents.overrides, 0, remarks), remarks), remarks);
  return Deck(std::move(contents));
}

/// Reads one text into an assignment.
class AssignmentReader {
 public:
  explicit AssignmentReader(const std::string& text) : text_(text) {}

  Assignment read(Taken taken) {
    parse();
    if (!result_.mistakes.empty()) return std::move(result_);
    take_apart();
    if (taken == Taken::together || find_variable(result_.group, result_.name) == nullptr)
      try_override(text_, 0);
    else if (taken == Taken::one_by_one)
      try_values();
    if (result_.mistakes.empty()) find_elements();
    return std::move(result_);
  }

 private:
  void parse() {
    Diagnostics diagnostics;
    const std::vector<std::string> lines{text_};
    Remarks remarks("", lines, 1, diagnostics);
    item_ = parse_override(lex_override(lines, 0, remarks), remarks);
    for (const auto& error : diagnostics.errors()) add({error.place.column, error.message, error.hint});
    if (result_.mistakes.empty() && item_.values.empty()) add({1, "no value is given", "Write group.name=value."});
    for (const auto& value : item_.values) {
      if (value.kind == ItemValue::Kind::null) add({1, "a value is missing", "Write v1,v2,..."});
    }
  }

  void take_apart() {
    result_.variable = without_blanks(text_.substr(0, text_.find('=')));
    const auto full = lower(item_.name.text);
    const auto dot = std::min(full.find('.'), full.size());
    result_.group = full.substr(0, dot);
    result_.name = full.substr(std::min(dot + 1, full.size()));
    for (const auto& value : item_.values) result_.values.push_back(spelled(value));
  }

  void try_values() {
    const int left = static_cast<int>(result_.variable.size()) + 1;
    for (std::size_t k = 0; k < result_.values.size(); ++k) {
      try_override(result_.override_text(k), item_.values[k].count_column - left - 1);
    }
  }

  /// Columns after the '=' are shifted to where the value stands in the text.
  void try_override(const std::string& override_text, int shift) {
    Diagnostics diagnostics;
    deck_of(override_text, diagnostics);
    const auto left = static_cast<int>(override_text.find('='));
    for (const auto& error : diagnostics.errors()) {
      add({error.place.column + (error.place.column > left ? shift : 0), error.message, error.hint});
    }
  }

  void find_elements() {
    const Variable& variable = *find_variable(result_.group, result_.name);
    Diagnostics diagnostics;
    const std::vector<std::string> lines{text_};
    Remarks remarks("", lines, 1, diagnostics);
    const auto elements = resolve_elements(variable, item_, remarks);
    for (const auto& error : diagnostics.errors()) add({error.place.column, error.message, error.hint});
    if (!elements) return;
    result_.first = elements->at(0);
    long long longest = 0, total = 0;
    for (const auto& value : item_.values) longest = std::max(longest, value.count), total += value.count;
    const auto name = [&](long long k) { return result_.group + "." + element_name(variable, elements->at(k)); };
    for (long long k = 0; k < longest; ++k) result_.one_value.insert(name(k));
    for (long long k = 0; k < std::min(total, elements->count()); ++k) result_.all.insert(name(k));
  }

  void add(const Mistake& mistake) {
    if (result_.mistakes.size() == most_mistakes) return;
    const auto same = [&](const Mistake& other) { return other.message == mistake.message; };
    if (std::none_of(result_.mistakes.begin(), result_.mistakes.end(), same)) result_.mistakes.push_back(mistake);
  }

  const std::string& text_;
  Item item_;
  Assignment result_;
};

}  // namespace

Cell Assignment::cell(std::size_t k) const {
  Diagnostics none;
  const auto data = deck_of(override_text(k), none).value({group, name}, first[0], first[1]).data;
  if (const auto* integer = std::get_if<long long>(&data)) return static_cast<double>(*integer);
  if (const auto* real = std::get_if<double>(&data)) return *real;
  if (const auto* text = std::get_if<std::string>(&data)) return *text;
  return value_text({data, {}});
}

Assignment read_assignment(const std::string& text, Taken taken) { return AssignmentReader(text).read(taken); }

}  // namespace tether
