// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.hpp"
#include "deck/table.hpp"

namespace tether {

/// The "file" of values that the command line sets.
constexpr std::string_view override_file = "--set";

/// Subscripts from 1; (i) is {i, 1}, a scalar is {1, 1}.
using Subscript = std::array<int, 2>;

/// Text after the last group, in which particle data may stand.
struct Trailer {
  int first_line = 0;  ///< line of the deck at which it begins, from 1
  std::string text;
};

/// What a deck says, each value with its place; immutable once read. Variables are handles of the table's rows. A value
/// that the deck does not give has the table's default.
class Deck {
 public:
  /// Built by the reader only.
  struct Contents {
    std::string file;                    ///< path as given
    std::string text;                    ///< the whole deck as read
    std::vector<std::string> lines;      ///< its lines
    std::vector<std::string> overrides;  ///< of the command line; line k of the file "--set" is overrides[k - 1]
    std::vector<std::string> header;     ///< the lines above the first group, verbatim
    Trailer trailer;
    std::map<std::string, Place> groups;                           ///< the groups that are there, and where they open
    std::map<std::string, std::map<Subscript, DeckValue>> values;  ///< by "group.name"
    std::set<std::string> failed;                  ///< "group.name" of variables that the deck tried to set, in vain
    std::shared_ptr<const std::string> mesh_text;  ///< of the file that $mesh names, once it is read
  };
  explicit Deck(Contents contents);

  const std::string& file() const { return contents_.file; }
  const std::string& text() const { return contents_.text; }
  const std::vector<std::string>& header() const { return contents_.header; }
  const Trailer& trailer() const { return contents_.trailer; }
  const std::vector<std::string>& lines() const { return contents_.lines; }
  bool has_group(std::string_view group) const;
  /// Returns whether it is a study deck, which describes many runs and is none itself.
  bool is_study() const { return has_group(study_group); }
  /// The groups of the table that such a deck may have, in its order; $published and $auto where it has them.
  std::vector<std::string> possible_groups() const;

  /// Returns whether every required variable is given, so that a scene can be made of it.
  bool complete() const;

  // The value of an element, given or default: deck.real("reg.matr", 1, r). Throws std::logic_error where it has
  // neither: ask given() first for a variable without a default.
  int integer(IntegerVariable variable, int i = 1, int j = 1) const;
  double real(RealVariable variable, int i = 1, int j = 1) const;
  bool logical(LogicalVariable variable, int i = 1, int j = 1) const;
  std::string text(TextVariable variable, int i = 1, int j = 1) const;
  /// Returns a value of any type; a default's place is empty.
  DeckValue value(AnyVariable variable, int i = 1, int j = 1) const;

  bool given(AnyVariable variable, int i = 1, int j = 1) const;
  /// All elements the deck gives, in column-major order.
  std::vector<Subscript> given_elements(AnyVariable variable) const;

  /// Returns the same deck with these lines of particle data after its groups, in place of the file that it names;
  /// without the notes after the data, from the first one on that would open a group.
  Deck with_particle_data(const std::vector<std::string>& particle_lines) const;

  /// Returns the same deck with that path named in $in.
  Deck with_path(const std::string& path) const;
  /// Returns the same deck without the variables that are not wanted, and without the groups of which none is.
  Deck with_only(const std::function<bool(const Variable&)>& wanted) const;
  /// Returns the same deck with the text of the mesh file that it names.
  Deck with_mesh_text(std::string text) const;
  /// That text, or null where no file was named or read.
  const std::shared_ptr<const std::string>& mesh_text() const { return contents_.mesh_text; }
  /// Returns the same deck with that file under another name, and with the SHA-256 of its text.
  Deck with_mesh_named(const std::string& file) const;

  /// Returns where an element was given; else where its group opens; else the file as a whole.
  Place place(AnyVariable variable, int i = 1, int j = 1) const;
  /// Returns where byte `offset` (from 0) of a text that the deck gives stands within its quotes.
  Place place_within(AnyVariable variable, Subscript at, std::size_t offset) const;
  /// The text of a line of the deck (empty for line 0), for diagnostics.
  std::string line_text(const Place& place) const;
  /// A remark on an element's value, at its place, with its line; an error is moot where the deck tried in vain to give
  /// the element, which was reported.
  Diagnostic remark(Severity severity, AnyVariable variable, Subscript at, std::string message,
                    std::string hint = {}) const;
  /// A remark on a group as a whole, where it opens.
  Diagnostic remark_on_group(Severity severity, std::string_view group, std::string message,
                             std::string hint = {}) const;
  /// Does the same on one byte of a text.
  Diagnostic remark_within(Severity severity, AnyVariable variable, Subscript at, std::size_t offset,
                           std::string message, std::string hint = {}) const;

 private:
  const std::vector<std::string>& lines_of(const Place& place) const;
  const DeckValue* find(AnyVariable variable, int i, int j) const;
  Place place_of_group(std::string_view group) const;
  Contents contents_;
};

}  // namespace tether
