// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/text.hpp"
#include "deck/opener.hpp"
#include "deck/spelling.hpp"

namespace tether {
namespace {

template <typename Type>
Type get(const DeckValue& value, AnyVariable variable) {
  const auto* data = std::get_if<Type>(&value.data);
  if (data == nullptr) throw std::logic_error(fmt::format("{} is of another type", key_of(variable.row())));
  return *data;
}

}  // namespace

Deck::Deck(Contents contents) : contents_(std::move(contents)) {}

bool Deck::has_group(std::string_view group) const { return contents_.groups.count(std::string(group)) > 0; }

std::vector<std::string> Deck::possible_groups() const {
  auto groups = group_names();
  std::erase_if(groups, [this](const std::string& group) {
    return (is_about_runs(group) && !has_group(group)) || (group == study_group) != is_study();
  });
  return groups;
}

const DeckValue* Deck::find(AnyVariable variable, int i, int j) const {
  const auto all = contents_.values.find(key_of(variable.row()));
  if (all == contents_.values.end()) return nullptr;
  const auto element = all->second.find({i, j});
  return element == all->second.end() ? nullptr : &element->second;
}

DeckValue Deck::value(AnyVariable variable, int i, int j) const {
  if (const auto* given = find(variable, i, j)) return *given;
  const auto fallback = default_value(variable.row());
  if (!fallback) throw std::logic_error(fmt::format("{} is not given and has no default", key_of(variable.row())));
  return *fallback;
}

int Deck::integer(IntegerVariable variable, int i, int j) const {
  return static_cast<int>(get<long long>(value(variable, i, j), variable));
}

double Deck::real(RealVariable variable, int i, int j) const { return get<double>(value(variable, i, j), variable); }

bool Deck::logical(LogicalVariable variable, int i, int j) const { return get<bool>(value(variable, i, j), variable); }

std::string Deck::text(TextVariable variable, int i, int j) const {
  return get<std::string>(value(variable, i, j), variable);
}

bool Deck::given(AnyVariable variable, int i, int j) const { return find(variable, i, j) != nullptr; }

std::vector<Subscript> Deck::given_elements(AnyVariable variable) const {
  std::vector<Subscript> elements;
  const auto all = contents_.values.find(key_of(variable.row()));
  if (all == contents_.values.end()) return elements;
  for (const auto& [at, value] : all->second) elements.push_back(at);
  std::stable_sort(elements.begin(), elements.end(), [](const auto& a, const auto& b) { return a[1] < b[1]; });
  return elements;
}

bool Deck::complete() const {
  const auto table = variables();
  return std::all_of(table.begin(), table.end(),
                     [this](const Variable& variable) { return !variable.required || given(AnyVariable(variable)); });
}

Deck Deck::with_particle_data(const std::vector<std::string>& particle_lines) const {
  Contents contents = contents_;
  contents.values.erase("in.particles");
  contents.trailer.text.clear();
  for (const auto& line : particle_lines) {
    if (opener_of(line)) break;  // no data begin so: this is a note after them
    contents.trailer.text += line + "\n";
  }
  return Deck(std::move(contents));
}

Deck Deck::with_path(const std::string& path) const {
  Contents contents = contents_;
  contents.values["in.path"][{1, 1}] = {path, place_of_group("in")};
  return Deck(std::move(contents));
}

Deck Deck::with_only(const std::function<bool(const Variable&)>& wanted) const {
  Contents contents = contents_;
  std::set<std::string> groups{std::string(study_group), std::string(published_group), std::string(auto_group)};
  for (const Variable& variable : variables()) {
    if (wanted(variable)) {
      groups.insert(std::string(variable.group));
      continue;
    }
    const std::string key = key_of(variable);
    contents.values.erase(key), contents.failed.erase(key);
  }
  std::erase_if(contents.groups, [&](const auto& group) { return groups.count(group.first) == 0; });
  return Deck(std::move(contents));
}

Deck Deck::with_mesh_text(std::string text) const {
  Contents contents = contents_;
  contents.mesh_text = std::make_shared<const std::string>(std::move(text));
  return Deck(std::move(contents));
}

Deck Deck::with_mesh_named(const std::string& file) const {
  Contents contents = contents_;
  contents.values["mesh.file"][{1, 1}].data = file;
  contents.values["mesh.file_sha256"][{1, 1}].data = sha256(*contents_.mesh_text);
  return Deck(std::move(contents));
}

Place Deck::place(AnyVariable variable, int i, int j) const {
  if (const auto* given = find(variable, i, j)) return given->place;
  return place_of_group(variable.group());
}

Place Deck::place_of_group(std::string_view group) const {
  const auto opened = contents_.groups.find(std::string(group));
  return opened == contents_.groups.end() ? Place{contents_.file, 0, 0} : opened->second;
}

const std::vector<std::string>& Deck::lines_of(const Place& place) const {
  return place.file == override_file ? contents_.overrides : contents_.lines;
}

/// From the opening quote on: a quote within the text is written twice, and the text may go on over ends of lines.
Place Deck::place_within(AnyVariable variable, Subscript at, std::size_t offset) const {
  Place place = this->place(variable, at[0], at[1]);
  const auto& lines = lines_of(place);
  auto line = static_cast<std::size_t>(place.line) - 1;
  if (place.line < 1 || line >= lines.size()) return place;
  std::size_t column = lines[line].find_first_of("'\"", static_cast<std::size_t>(place.column) - 1);
  if (column == std::string::npos) return place;
  const char quote = lines[line][column++];
  const auto at_end = [&] { return column >= lines[line].size() && line + 1 < lines.size(); };
  for (std::size_t k = 0; k < offset; ++k) {
    while (at_end()) ++line, column = 0;
    if (column >= lines[line].size()) break;
    column += lines[line].compare(column, 2, std::string(2, quote)) == 0 ? 2U : 1U;
  }
  while (at_end()) ++line, column = 0;
  return {place.file, static_cast<int>(line) + 1, static_cast<int>(column) + 1};
}

std::string Deck::line_text(const Place& place) const {
  const auto& lines = lines_of(place);
  const auto index = static_cast<std::size_t>(place.line) - 1;
  return place.line > 0 && index < lines.size() ? lines[index] : "";
}

Diagnostic Deck::remark(Severity severity, AnyVariable variable, Subscript at, std::string message,
                        std::string hint) const {
  const auto where = place(variable, at[0], at[1]);
  const bool moot = severity == Severity::error && !given(variable, at[0], at[1]) &&
                    contents_.failed.count(key_of(variable.row())) > 0;
  return {severity, where, line_text(where), std::move(message), std::move(hint), moot};
}

Diagnostic Deck::remark_on_group(Severity severity, std::string_view group, std::string message,
                                 std::string hint) const {
  const auto where = place_of_group(group);
  return {severity, where, line_text(where), std::move(message), std::move(hint), false};
}

Diagnostic Deck::remark_within(Severity severity, AnyVariable variable, Subscript at, std::size_t offset,
                               std::string message, std::string hint) const {
  const auto where = place_within(variable, at, offset);
  return {severity, where, line_text(where), std::move(message), std::move(hint)};
}

}  // namespace tether
