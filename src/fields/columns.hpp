// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "fields/column_text.hpp"
#include "fields/fields_in_turn.hpp"

// A column is a description with a function of what is computed once for a record: the layout of a history and its
// records come from the same rows, and so do a snapshot's names and its values. A physics writes its rows once, with
// the condition of each row or group of rows; Columns are those of one run.

namespace tether {

/// What decides which rows of a table a run has. A physics derives its own from it.
struct ColumnSetting {
  int dim = 2;  ///< axes of a vector
  std::vector<std::string> body_names = {}, point_names = {};
};

/// When rows are there, or how many times, in words for the guides and as a function. Without one: always, once.
template <class Setting>
struct When {
  using Count = std::function<std::size_t(const Setting&)>;

  When() = default;
  When(std::string in_words, Count how_often) : words(std::move(in_words)), count(std::move(how_often)) {}
  /// Takes the same of what a setting is derived from.
  template <class Base>
  requires std::derived_from<Setting, Base> When(const When<Base>& of) : words(of.words), count(of.count) {}

  std::string words;
  Count count;

  std::size_t times(const Setting& setting) const { return count ? count(setting) : 1; }
};

/// A function of a record's source: f(source), a member of it, f(source, k) of body, point or number k, or of vectors
/// f(source, axis, k). It fills the numbers of successive k.
template <class Source>
class Value {
 public:
  template <class F>
  requires std::invocable<const F&, const Source&> || std::invocable<const F&, const Source&, std::size_t> ||
      std::invocable<const F&, const Source&, std::size_t, std::size_t>
      Value(F f)
      : fill_([f](const Source& source, std::size_t axis, std::size_t first, std::span<double> numbers) {
          for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = number(f, source, axis, first + k);
        }) {}
  /// Takes the value of what a source is derived from.
  template <class Base>
  requires(std::derived_from<Source, Base> && !std::same_as<Source, Base>) Value(const Value<Base>& other)
      : fill_(other.fill_) {}

  void fill(const Source& source, std::size_t axis, std::size_t first, std::span<double> numbers) const {
    fill_(source, axis, first, numbers);
  }

 private:
  template <class Derived>
  friend class Value;

  template <class F>
  static double number(const F& f, const Source& source, [[maybe_unused]] std::size_t axis,
                       [[maybe_unused]] std::size_t k) {
    if constexpr (std::invocable<const F&, const Source&>) {
      return static_cast<double>(std::invoke(f, source));
    } else if constexpr (std::invocable<const F&, const Source&, std::size_t>) {
      return static_cast<double>(std::invoke(f, source, k));
    } else {
      return static_cast<double>(std::invoke(f, source, axis, k));
    }
  }

  std::function<void(const Source&, std::size_t, std::size_t, std::span<double>)> fill_;
};

/// One row: what a column is called and means, and what it is.
template <class Setting, class Source>
class Column {
 public:
  using Meaning = std::function<std::string(const Setting&, std::size_t)>;

  Column(std::string name, Dimension dimension, std::string meaning, Value<Source> value)
      : quantity_{std::move(name), dimension, std::move(meaning)}, value_(std::move(value)) {}
  /// Takes the same of what setting and source are derived from.
  template <class BaseSetting, class BaseSource>
  requires(!std::same_as<Column<BaseSetting, BaseSource>, Column>) Column(const Column<BaseSetting, BaseSource>& of)
      : quantity_(of.quantity_), value_(of.value_), vector_(of.vector_), when_(of.when_), meaning_of_(of.meaning_of_) {}

  /// One of each body or tracked point.
  Column& each(Per per) { return quantity_.per = per, *this; }
  Column& booked(Book book) { return quantity_.book = book, *this; }
  /// A column for each axis of the setting, whose letter its name ends with.
  Column& vector() { return vector_ = true, *this; }
  Column& when(std::string words, std::function<std::size_t(const Setting&)> count) {
    return when_ = {std::move(words), std::move(count)}, *this;
  }
  Column& when(const When<Setting>& when) { return when_ = when, *this; }
  /// The meaning of number k where it differs from one to the next; the guides have the row's own.
  Column& meaning_of(Meaning meaning) { return meaning_of_ = std::move(meaning), *this; }

  bool is_there(const Setting& setting) const { return when_.times(setting) > 0; }
  std::size_t axes(const Setting& setting) const { return vector_ ? static_cast<std::size_t>(setting.dim) : 1; }
  /// Returns the quantity of an axis and, where the rows are numbered, of number k.
  Quantity quantity(const Setting& setting, bool numbered, std::size_t k, std::size_t axis) const {
    Quantity q = quantity_;
    if (meaning_of_) q.meaning = meaning_of_(setting, k);
    if (vector_) q.name += "xyz"[axis], (q.meaning += ", ") += "xyz"[axis];
    if (numbered) (q.name += "_") += std::to_string(k + 1);
    return q;
  }
  const Value<Source>& value() const { return value_; }
  ColumnText text(const std::string& condition, bool numbered) const {
    const bool several = numbered || quantity_.per != Per::scene;
    return {column_text_name(quantity_.name, vector_, several), quantity_.dimension, quantity_.meaning,
            joined_conditions(condition, when_.words)};
  }

 private:
  template <class S, class T>
  friend class Column;

  Quantity quantity_;
  Value<Source> value_;
  bool vector_ = false;
  When<Setting> when_;
  Meaning meaning_of_;
};

/// Rows of one condition. Numbered ones are there as many times as it says, all rows of number 1 before those of 2.
template <class Setting, class Source>
struct ColumnGroup {
  using Row = Column<Setting, Source>;

  ColumnGroup(std::vector<Row> rows) : columns(std::move(rows)) {}
  ColumnGroup(When<Setting> condition, std::vector<Row> rows) : when(std::move(condition)), columns(std::move(rows)) {}
  /// Takes the same of what setting and source are derived from.
  template <class BaseSetting, class BaseSource>
  requires(!std::same_as<ColumnGroup<BaseSetting, BaseSource>, ColumnGroup>)
      ColumnGroup(const ColumnGroup<BaseSetting, BaseSource>& of)
      : when(of.when), numbered(of.numbered), columns(of.columns.begin(), of.columns.end()) {}

  When<Setting> when;
  bool numbered = false;
  std::vector<Row> columns;
};

template <class Setting, class Source>
ColumnGroup<Setting, Source> numbered(ColumnGroup<Setting, Source> group) {
  group.numbered = true;
  return group;
}

/// A group without a condition, under one.
template <class Setting, class Source>
ColumnGroup<Setting, Source> given(When<Setting> when, ColumnGroup<Setting, Source> group) {
  if (group.when.count) throw std::logic_error("a group of columns has one condition");
  group.when = std::move(when);
  return group;
}

/// All rows that a physics may have, in the order of its history.
template <class Setting, class Source>
class ColumnTable {
 public:
  using Group = ColumnGroup<Setting, Source>;

  ColumnTable(std::vector<Group> groups) : groups_(std::move(groups)) {}
  const std::vector<Group>& groups() const { return groups_; }
  /// All rows, for the guides.
  std::vector<ColumnText> described() const {
    std::vector<ColumnText> texts;
    for (const Group& group : groups_) {
      for (const auto& column : group.columns) texts.push_back(column.text(group.when.words, group.numbered));
    }
    return texts;
  }

 private:
  std::vector<Group> groups_;
};

/// The columns of one run: the rows of a table whose conditions hold.
template <class Source>
class Columns {
 public:
  /// Throws std::logic_error where two rows of the same name are chosen.
  template <class Setting>
  Columns(const ColumnTable<Setting, Source>& table, const Setting& setting) {
    layout_.body_names = setting.body_names, layout_.point_names = setting.point_names;
    for (const auto& group : table.groups()) {
      const std::size_t times = group.when.times(setting);
      for (std::size_t k = 0; k < (group.numbered ? times : times > 0); ++k) {
        for (const auto& column : group.columns) {
          if (column.is_there(setting)) choose(column, setting, group.numbered, k);
        }
      }
    }
    refuse_twins(layout_.quantities);
  }

  const HistoryLayout& layout() const { return layout_; }

  Record record(const Source& source) const {
    Record numbers;
    for (std::size_t c = 0; c < chosen_.size(); ++c) append(c, layout_.count(layout_.quantities[c]), source, numbers);
    return numbers;
  }

  /// As many numbers of each column as there are points, nodes or cells.
  Snapshot snapshot(double time, std::size_t count, const Source& source) const {
    return in_turn(time, count, [&source]() -> const Source& { return source; }).snapshot();
  }
  /// Returns the same one after the other; source() hands over what they are made from.
  template <class SourceOf>
  FieldsInTurn in_turn(double time, std::size_t count, SourceOf source) const {
    return {time, layout_.quantities, count, [columns = *this, source](std::size_t c, std::span<double> numbers) {
              columns.chosen_[c].value.fill(source(), columns.chosen_[c].axis, columns.chosen_[c].first, numbers);
            }};
  }

 private:
  /// Where the quantity of the same place in the layout comes from.
  struct Chosen {
    Value<Source> value;
    std::size_t axis, first;
  };

  template <class Setting>
  void choose(const Column<Setting, Source>& column, const Setting& setting, bool numbered, std::size_t k) {
    for (std::size_t axis = 0; axis < column.axes(setting); ++axis) {
      layout_.quantities.push_back(column.quantity(setting, numbered, k, axis));
      chosen_.push_back({column.value(), axis, k});
    }
  }

  void append(std::size_t c, std::size_t count, const Source& source, std::vector<double>& numbers) const {
    const std::size_t before = numbers.size();
    numbers.resize(before + count);
    chosen_[c].value.fill(source, chosen_[c].axis, chosen_[c].first, std::span(numbers).subspan(before));
  }

  HistoryLayout layout_;
  std::vector<Chosen> chosen_;
};

}  // namespace tether
