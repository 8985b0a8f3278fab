// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <array>
#include <concepts>
#include <initializer_list>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "deck/groups/added.hpp"
#include "deck/groups/automatic.hpp"
#include "deck/groups/contact.hpp"
#include "deck/groups/coupled.hpp"
#include "deck/groups/fem.hpp"
#include "deck/groups/flow.hpp"
#include "deck/groups/membrane.hpp"
#include "deck/groups/study.hpp"
#include "deck/groups/thesis.hpp"
#include "deck/variable.hpp"

namespace tether {

/// THE table: all rows, those of a group together, in the order in which decks and documents show them.
inline constexpr auto variable_table = [] {
  constexpr std::array<std::span<const Variable>, 14> parts{
      thesis_table::in_rows,         thesis_table::fluid_rows,   thesis_table::reg_rows,
      membrane_table::membrane_rows, added_table::added_rows,    fem_table::fem_rows,
      contact_table::contact_rows,   fem_table::rigid_rows,      flow_table::flow_rows,
      coupled_table::coupled_rows,   study_table::study_rows,    study_table::chart_rows,
      study_table::published_rows,   automatic_table::auto_rows,
  };
  constexpr std::size_t count = [&] {
    std::size_t sum = 0;
    for (const auto part : parts) sum += part.size();
    return sum;
  }();
  std::array<Variable, count> rows{};
  std::size_t k = 0;
  for (const auto part : parts) {
    for (const Variable& row : part) rows[k++] = row;
  }
  return rows;
}();
constexpr std::span<const Variable> variables() { return variable_table; }

/// Number of the row of group.name (lower case), or how many rows there are.
constexpr std::size_t variable_number(std::string_view group, std::string_view name) {
  std::size_t k = 0;
  while (k < variable_table.size() && (variable_table[k].name != name || variable_table[k].group != group)) ++k;
  return k;
}
/// That row, or null.
constexpr const Variable* find_variable(std::string_view group, std::string_view name) {
  const std::size_t k = variable_number(group, name);
  return k < variable_table.size() ? &variable_table[k] : nullptr;
}

/// "mpm.cfl": under this name a deck's values are kept. It is made often, as a sweep reads its deck for each run.
std::string key_of(const Variable& variable);

/// All groups, in the order of the table.
std::vector<std::string> group_names();
bool is_group(std::string_view name);

/// Returns whether a group says something by being there alone: it chooses the path of a deck, or turns contact on.
bool acts_by_presence(std::string_view group);

/// A variable of the table, of any type, by its name "flow.speed": a name without a row does not compile.
class AnyVariable {
 public:
  consteval AnyVariable(const char* full_name) : row_(&row_of(full_name)) {}  // NOLINT: written as a text
  /// One whose name is known only while the program runs. Throws std::logic_error where the table has no such row.
  AnyVariable(std::string_view group, std::string_view name);
  explicit constexpr AnyVariable(const Variable& row) : row_(&row) {}

  constexpr const Variable& row() const { return *row_; }
  constexpr std::string_view group() const { return row_->group; }
  constexpr std::string_view name() const { return row_->name; }
  /// The variable of the same group whose name begins with this one's: "coupled.jet" and "_on" are coupled.jet_on.
  AnyVariable with(std::string_view ending) const;
  constexpr bool operator==(AnyVariable other) const { return row_ == other.row_; }

 private:
  static constexpr const Variable& row_of(std::string_view full_name) {
    const std::size_t dot = full_name.find('.');
    const std::size_t k = dot == full_name.npos ? variable_table.size()
                                                : variable_number(full_name.substr(0, dot), full_name.substr(dot + 1));
    // By number: GCC 12 takes no comparison of addresses with null for a constant under -fsanitize=undefined.
    if (k == variable_table.size()) throw std::logic_error("the table of variables has no such name");
    return variable_table[k];
  }
  const Variable* row_;
};

/// One of a given type: a row of another type does not compile.
template <ValueType type>
class TypedVariable : public AnyVariable {
 public:
  consteval TypedVariable(const char* full_name) : AnyVariable(full_name) { check(); }  // NOLINT: written as a text
  /// Throws std::logic_error where the row is of another type.
  TypedVariable(std::string_view group, std::string_view name) : AnyVariable(group, name) { check(); }
  constexpr TypedVariable(AnyVariable any)  // NOLINT: a name of a list of names
      : AnyVariable(any) {
    check();
  }

 private:
  constexpr void check() const {
    if (row().type != type) throw std::logic_error("the table of variables has that name with another type");
  }
};

/// Names that a loop goes through: for (const AnyVariable name : Variables{"reg.vrx", "reg.vry"}).
using Variables = std::initializer_list<AnyVariable>;
using IntegerVariable = TypedVariable<ValueType::integer>;
using RealVariable = TypedVariable<ValueType::real>;
using LogicalVariable = TypedVariable<ValueType::logical>;
using TextVariable = TypedVariable<ValueType::text>;

}  // namespace tether

/// A message writes a variable by its name alone.
template <std::derived_from<tether::AnyVariable> Handle>
struct fmt::formatter<Handle> : fmt::formatter<std::string_view> {
  template <class Context>
  auto format(const tether::AnyVariable& variable, Context& context) const {
    return fmt::formatter<std::string_view>::format(variable.name(), context);
  }
};
