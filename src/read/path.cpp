// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/path.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string>

#include "base/text.hpp"
#include "deck/spelling.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

constexpr std::string_view bars = "bars";  // of strings: a word for the path fem where the deck has a mesh, too

/// Which paths have which region, where the deck says so.
void check_paths(const Deck& deck, Diagnostics& diagnostics) {
  const std::vector<std::string> all = split_choices(AnyVariable("in.path").row());
  std::string left_out;
  Subscript first{};
  for (const Subscript at : deck.given_elements("reg.paths")) {
    for (const std::string& path : split_words(deck.text("reg.paths", at[0]))) {
      if (std::find(all.begin(), all.end(), path) != all.end()) continue;
      diagnostics.add(deck.remark(Severity::error, "reg.paths", at, fmt::format("'{}' is no path", path),
                                  fmt::format("{}, with blanks between", fmt::join(all, ", "))));
    }
    if (at[0] > deck.integer("reg.nreg") || has_region(deck, at[0])) continue;
    if (left_out.empty()) first = at;
    left_out += fmt::format("{}{}", left_out.empty() ? "" : ", ", at[0]);
  }
  if (!deck.given("in.path") && !deck.given_elements("reg.paths").empty())
    diagnostics.add(deck.remark(Severity::warning, "reg.paths", deck.given_elements("reg.paths").front(),
                                "paths has no effect: the deck names no path", "path of $in, or --path, does"));
  if (!left_out.empty())
    diagnostics.add(
        deck.remark(Severity::remark, "reg.paths", first,
                    fmt::format("the {} path leaves regions of others out: {}", deck.text("in.path"), left_out)));
}

/// The path that the deck's groups ask for.
Path path_of_groups(const Deck& deck) {
  if (deck.has_group("coupled")) return Path::coupled;
  const bool fem = deck.has_group("mesh") || deck.has_group("rigid") || deck.has_group("fem") || has_flow(deck);
  return fem ? Path::fem : Path::mpm;
}

/// Whether a path has a use for a variable.
using Used = std::function<bool(const Variable&)>;

template <std::size_t n>
bool is_one_of(std::string_view name, const std::array<std::string_view, n>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Returns whether it is of a fluid's box, whose solids take the step that $coupled says and stand in its walls.
bool is_of_boxes(const Variable& variable) {
  constexpr std::array<std::string_view, 5> of_other_steps{"static", "settle", "integrator", "tolerance", "cfl"};
  constexpr std::array<std::string_view, 4> walls{"wl", "wr", "wb", "wt"};
  if (variable.group == "contact" || variable.group == "flow" || variable.group == "rigid") return false;
  if (variable.group == "fem") return !is_one_of(variable.name, of_other_steps);
  if (variable.group == "in") return is_of_meshes(variable) && !is_one_of(variable.name, walls);
  return is_of_meshes(variable);
}

/// Returns whether it makes elements of regions, or acts on them; strings have none of it.
bool is_of_mesh_alone(const Variable& variable) {
  if (variable.group == "fem") return variable.name != "cfl";
  constexpr std::array<std::string_view, 4> of_meshes{"mesh", "contact", "rigid", "flow"};
  return is_one_of(variable.group, of_meshes);
}

/// Returns whether the path has a use for a variable of this deck. Exact solutions are of points and bars.
bool is_of(Path path, bool mesh, const Variable& variable) {
  if (variable.group == "reference") return path == Path::mpm || (path == Path::fem && !mesh);
  if (path == Path::coupled) return is_of_boxes(variable);
  if (path == Path::fem) return variable.group != "coupled" && (!mesh || is_of_meshes(variable));
  return !acts_by_presence(variable.group);
}

/// Returns whether a deck says more of a variable than what stands there by itself.
bool says(const Deck& deck, AnyVariable variable) {
  const auto elements = deck.given_elements(variable);
  return std::any_of(elements.begin(), elements.end(),
                     [&](const Subscript& at) { return !is_default(deck, variable, at); });
}

/// Remarks on what is left out of a group.
void note_unused(const Deck& deck, const std::string& group, Path path, const Used& used, Diagnostics& diagnostics) {
  bool whole = true;
  std::string names;
  Subscript at{};
  std::optional<AnyVariable> first;
  for (const Variable& variable : variables()) {
    if (variable.group != group) continue;
    if (used(variable)) {
      whole = false;
    } else if (says(deck, AnyVariable(variable))) {
      names += fmt::format("{}{}", names.empty() ? "" : ", ", variable.name);
      if (!first) first = AnyVariable(variable), at = deck.given_elements(*first).front();
    }
  }
  const std::string what = fmt::format("the {} path has no use for ", path_name(path));
  if (whole) return diagnostics.add(deck.remark_on_group(Severity::remark, group, what + "$" + group));
  if (first) diagnostics.add(deck.remark(Severity::remark, *first, at, fmt::format("{}{} of ${}", what, names, group)));
}

/// Warns of what acts on the scene by another path and is left out: the scene is another one then.
void warn_of_lost_actions(const Deck& deck, Path path, const Used& used, Diagnostics& diagnostics) {
  for (const AnyVariable name :
       Variables{"fem.static", "fem.settle", "fem.load_on", "contact.plane", "contact.obstacle", "flow.boundary",
                 "coupled.jet_on", "coupled.spring_on", "coupled.hinge"}) {
    if (used(name.row()) || !says(deck, name)) continue;
    diagnostics.add(deck.remark(Severity::warning, name, deck.given_elements(name).front(),
                                fmt::format("the {} path leaves {} of ${} out, which acts on the scene",
                                            path_name(path), name.name(), name.group()),
                                "the path runs the scene without it"));
  }
}

}  // namespace

bool is_of_meshes(const Variable& variable) {
  constexpr std::array<std::string_view, 12> of_regions{"nreg",  "nvi", "xvi", "yvi", "densir",     "matr",
                                                        "ipath", "vrx", "vry", "law", "volumetric", "paths"};
  if (variable.group == "reg") return is_one_of(variable.name, of_regions);
  if (variable.group == "points") return variable.name == "tracked_at";
  if (variable.group == "in") return variable.name != "particles";
  if (variable.group == "fluid") return variable.name == "pambient";  // reported elsewhere
  return variable.group != "membrane" && variable.group != "mpm";
}

Path path_of(const Deck& deck, Diagnostics& diagnostics) {
  if (!deck.given("in.path")) return path_of_groups(deck);
  const std::string name = deck.text("in.path");
  if (name == path_name(Path::coupled) && !deck.has_group("coupled")) {
    diagnostics.add(deck.remark(Severity::error, "in.path", {1, 1}, "the coupled path needs $coupled",
                                "it describes the fluid in the box of $in"));
    return path_of_groups(deck);
  }
  if (name == bars) return Path::fem;
  return name == path_name(Path::coupled) ? Path::coupled : name == path_name(Path::fem) ? Path::fem : Path::mpm;
}

Deck deck_of_path(const Deck& deck, Path path, Diagnostics& diagnostics) {
  check_paths(deck, diagnostics);
  if (!deck.given("in.path")) return deck;
  const bool strings = deck.text("in.path") == bars;
  const bool mesh = !strings && (deck.has_group("mesh") || deck.has_group("rigid") || has_flow(deck));
  const Used used = [&](const Variable& variable) {
    return is_of(path, mesh, variable) && !(strings && is_of_mesh_alone(variable));
  };
  for (const auto& group : group_names()) {
    if (deck.has_group(group) && group != study_group && !is_about_runs(group))
      note_unused(deck, group, path, used, diagnostics);
  }
  warn_of_lost_actions(deck, path, used, diagnostics);
  return deck.with_only(used);
}

}  // namespace tether
