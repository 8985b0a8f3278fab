// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/assign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/text.hpp"
#include "deck/elements.hpp"
#include "deck/spelling.hpp"

namespace tether {
namespace {

/// Returns whether an item has a value that is not null.
bool says_something(const Item& item) {
  return std::any_of(item.values.begin(), item.values.end(),
                     [](const ItemValue& value) { return value.kind != ItemValue::Kind::null; });
}

/// "0,01" where `value` and `next` are digits with nothing but a comma between them; empty where they are not.
std::string decimal_comma(const ItemValue& value, const ItemValue& next) {
  const auto digits = [](const std::string& text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  };
  const bool sign = value.text.starts_with('-') || value.text.starts_with('+');
  const auto exponent = std::min(next.text.find_first_of("eEdD"), next.text.size());
  const bool numbers = digits(value.text.substr(sign ? 1 : 0)) && digits(next.text.substr(0, exponent));
  const bool words = value.kind == ItemValue::Kind::word && next.kind == value.kind && !value.counted && !next.counted;
  const bool glued = next.line == value.line && next.column == value.column + static_cast<int>(value.text.size()) + 1;
  return words && numbers && glued ? value.text + "," + next.text : "";
}

/// The values of one item on their way into the elements of one variable.
class Filling {
 public:
  Filling(const Variable& variable, const Elements& elements, std::map<Subscript, DeckValue>& slots, bool replaces,
          Remarks& remarks)
      : variable_(variable), elements_(elements), slots_(slots), replaces_(replaces), remarks_(remarks) {}

  /// Takes one value (repeated or null); false where the item has to be given up.
  bool take(const ItemValue& value, long long& budget);
  /// Warns of values that began inside a column and ran on into the next.
  void tell_of_next_column(const Token& name) const;

 private:
  bool too_many(const ItemValue& value);
  void store(Subscript at, const DeckValue& value);

  const Variable& variable_;
  const Elements& elements_;
  std::map<Subscript, DeckValue>& slots_;
  bool replaces_;
  bool told_twice_ = false;
  Remarks& remarks_;
  long long next_ = 0;    ///< the element the next value goes to
  long long filled_ = 0;  ///< after the last element that got a value
};

bool Filling::take(const ItemValue& value, long long& budget) {
  const bool null = value.kind == ItemValue::Kind::null;
  const long long room = elements_.count() - next_;
  if (null && !value.counted) {
    next_ += room > 0 ? 1 : 0;
    return true;
  }
  // This is reported before anything is expanded: a count may be as large as a user can write.
  if (value.count > room) return too_many(value);
  const auto converted = null ? std::nullopt : convert(variable_, elements_.at(next_), value, remarks_);
  for (long long k = 0; converted && k < value.count && --budget >= 0; ++k) {
    store(elements_.at(next_ + k), *converted);
  }
  next_ += value.count;
  if (converted) filled_ = next_;
  return true;
}

bool Filling::too_many(const ItemValue& value) {
  const auto first = element_name(variable_, elements_.at(0));
  std::string message = fmt::format("{} takes one value, this is one too many", first);
  std::string hint;
  if (find_variable(variable_.group, lower(value.text)) != nullptr) {
    message = fmt::format("'=' is missing after {}", in_quotes(value.text));
    hint = "An item is: name = value.";
  } else if (variable_.rank > 0) {
    message = fmt::format("the values run past the end of {}: there are {} elements from {} on", variable_.name,
                          elements_.count(), first);
    hint = fmt::format("Its shape is {}.", shape_text(variable_));
  }
  remarks_.error(value.line, value.count_column, message, hint);
  return false;
}

void Filling::store(Subscript at, const DeckValue& value) {
  const auto [slot, fresh] = slots_.try_emplace(at, value);
  if (fresh) return;
  const auto& first = slot->second.place;
  if (first.file == override_file && !told_twice_) {
    remarks_.warn(value.place.line, value.place.column,
                  fmt::format("{} is set twice by --set; the later value holds", element_name(variable_, at)),
                  "Leave the earlier one away.");
    told_twice_ = true;
  } else if (!replaces_ && !told_twice_) {
    remarks_.warn(value.place.line, value.place.column,
                  fmt::format("{} is set twice, first at {}:{}; the later value holds", element_name(variable_, at),
                              first.line, first.column),
                  variable_.rank > 0 ? "Is the subscript right?" : "");
    told_twice_ = true;
  }
  slot->second = value;
}

void Filling::tell_of_next_column(const Token& name) const {
  const auto above = elements_.skipped % elements_.counts[0];
  const auto in_column = elements_.counts[0] - above;
  if (above == 0 || filled_ <= in_column) return;
  remarks_.warn(name.line, name.column,
                fmt::format("the values from {} on fill its column and go on at {}",
                            element_name(variable_, elements_.at(0)), element_name(variable_, elements_.at(in_column))),
                "Fortran compilers differ here: give the next column an item of its own.");
}

}  // namespace

namespace {

/// False where a number was written with a comma for its point: one value cannot be meant to be two. In arrays that is
/// only doubtful, where the second begins with a zero.
bool check_decimal_commas(const Variable& variable, const Item& item, Remarks& remarks) {
  if (variable.type != ValueType::real) return true;
  for (std::size_t k = 0; k + 1 < item.values.size(); ++k) {
    const ItemValue &value = item.values[k], &next = item.values[k + 1];
    const std::string written = decimal_comma(value, next);
    if (written.empty()) continue;
    const std::string hint = fmt::format("A decimal point is '.': {}.{}", value.text, next.text);
    if (variable.rank == 0) {
      remarks.error(value.line, value.column,
                    fmt::format("{} is two values: {} takes one", in_quotes(written), variable.name), hint);
      return false;
    }
    if (next.text.size() < 2 || next.text[0] != '0') continue;
    remarks.warn(value.line, value.column, fmt::format("{} is read as two values", in_quotes(written)), hint);
    return true;
  }
  return true;
}

}  // namespace

void Assigner::assign(const std::vector<Group>& groups, Remarks& remarks) {
  for (const auto& group : groups) {
    const auto& name = group.opener.text;
    const int line = group.opener.line, column = group.opener.column;
    if (!is_group(name)) {
      remarks.error(line, column, fmt::format("there is no group {}", in_quotes("$" + name)), suggest_group(name));
      continue;
    }
    const auto [first, fresh] = contents_.groups.try_emplace(name, remarks.place(line, column));
    if (!fresh) {
      remarks.warn(
          line, column,
          fmt::format("${} is there twice, first at line {}; the later values hold", name, first->second.line));
    }
    for (const auto& read : group.items) item(name, read, false, remarks);
  }
}

namespace {

/// A shell takes the quotes off group.name='text': on the command line a word is a text where the variable is one.
void quote_words(const std::string& group, Item& item) {
  const auto* variable = find_variable(group, lower(item.name.text));
  if (variable == nullptr || variable->type != ValueType::text) return;
  for (auto& value : item.values) {
    if (value.kind == ItemValue::Kind::word) value.kind = ItemValue::Kind::quoted;
  }
}

}  // namespace

void Assigner::assign_override(Item read, Remarks& remarks) {
  if (read.broken) return;
  const auto full_name = lower(read.name.text);
  const auto dot = full_name.find('.');
  const auto group = full_name.substr(0, dot == std::string::npos ? 0 : dot);
  if (!is_group(group)) {
    const auto hint = dot == std::string::npos ? suggest_variable("", full_name) : suggest_group(group);
    remarks.error(read.name.line, read.name.column, fmt::format("{} names no group", in_quotes(read.name.text)),
                  "An override is group.name=value. " + hint);
    return;
  }
  read.name.text.erase(0, dot + 1);
  read.name.column += static_cast<int>(dot) + 1;
  contents_.groups.try_emplace(group, remarks.place(read.name.line, 1));
  quote_words(group, read);
  item(group, read, true, remarks);
}

void Assigner::item(const std::string& group, const Item& item, bool replaces, Remarks& remarks) {
  const auto name = lower(item.name.text);
  const auto* variable = find_variable(group, name);
  if (variable == nullptr) {
    remarks.error(item.name.line, item.name.column,
                  fmt::format("${} has no variable {}", group, in_quotes(item.name.text)),
                  suggest_variable(group, name));
    if (const auto meant = meant_variable(group, name); !meant.empty()) fail(meant);
    return;
  }
  const int errors_before = remarks.errors();
  if (item.broken || says_something(item)) {
    mentioned_.insert(key_of(*variable));
  } else {
    left_empty_.try_emplace(key_of(*variable), remarks.place(item.name.line, item.name.column));
  }
  if (!item.broken) values(*variable, item, replaces, remarks);
  if (item.broken || remarks.errors() > errors_before) fail(key_of(*variable));
}

void Assigner::fail(const std::string& full_name) {
  mentioned_.insert(full_name);
  contents_.failed.insert(full_name);
}

void Assigner::values(const Variable& variable, const Item& item, bool replaces, Remarks& remarks) {
  const auto elements = resolve_elements(variable, item, remarks);
  if (!elements) return;
  if (!check_decimal_commas(variable, item, remarks)) return;
  Filling filling(variable, *elements, contents_.values[key_of(variable)], replaces, remarks);
  for (const auto& value : item.values) {
    if (!filling.take(value, budget_)) return;
    if (budget_ >= 0) continue;
    remarks.error(value.line, value.column, "the deck sets more than 500000 values", "Set each element once.");
    return;
  }
  filling.tell_of_next_column(item.name);
}

}  // namespace tether
