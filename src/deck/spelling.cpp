// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/spelling.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "base/numbers.hpp"
#include "base/text.hpp"
#include "deck/table.hpp"

namespace tether {
namespace {

std::string listed(const std::vector<std::string>& choices) {
  std::string text = choices.front();
  for (std::size_t k = 1; k < choices.size(); ++k) {
    text += (k + 1 == choices.size() ? " or " : ", ") + choices[k];
  }
  return text;
}

std::string bound_text(double bound) {
  return bound == std::floor(bound) ? fmt::format("{:.0f}", bound) : fmt::format("{}", bound);
}

/// The shortest decimal that reads back the same, with a '.' or an exponent.
std::string real_text(double value) {
  auto text = fmt::format("{}", value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string quote_text(const std::string& value) {
  std::string text = "'";
  for (const char c : value) {
    text += c;
    if (c == '\'') text += c;
  }
  return text + "'";
}

struct ValueText {
  std::string operator()(long long value) const { return fmt::format("{}", value); }
  std::string operator()(double value) const { return real_text(value); }
  std::string operator()(bool value) const { return value ? ".true." : ".false."; }
  std::string operator()(const std::string& value) const { return quote_text(value); }
};

}  // namespace

std::optional<DeckValue> default_value(const Variable& variable) {
  const auto fallback = variable.fallback;
  if (fallback.empty()) return std::nullopt;
  switch (variable.type) {
    case ValueType::integer:
      return DeckValue{parse_integer(fallback).value(), {}};
    case ValueType::real:
      return DeckValue{parse_real(fallback).value(), {}};
    case ValueType::logical:
      return DeckValue{fallback == ".true.", {}};
    default:
      return DeckValue{std::string(fallback.substr(1, fallback.size() - 2)), {}};
  }
}

std::string type_text(ValueType type) {
  switch (type) {
    case ValueType::integer:
      return "an integer";
    case ValueType::real:
      return "a number";
    case ValueType::logical:
      return ".true. or .false.";
    default:
      return "a text in quotes";
  }
}

std::vector<std::string> split_choices(const Variable& variable) {
  std::vector<std::string> choices;
  auto rest = variable.choices;
  while (!rest.empty()) {
    const auto bar = std::min(rest.find('|'), rest.size());
    choices.emplace_back(rest.substr(0, bar));
    rest.remove_prefix(std::min(bar + 1, rest.size()));
  }
  return choices;
}

std::string range_text(const Variable& variable) {
  if (!variable.choices.empty()) return listed(split_choices(variable));
  if (variable.type == ValueType::logical || variable.type == ValueType::text) return "";
  const bool integer = variable.type == ValueType::integer;
  const bool no_lowest = integer ? variable.low <= bounds::smallest_integer : std::isinf(variable.low);
  const bool no_highest = integer ? variable.high >= bounds::largest_integer : std::isinf(variable.high);
  if (no_lowest && no_highest) return "";
  if (variable.low == bounds::above_zero) return "> 0";
  if (no_highest) return ">= " + bound_text(variable.low);
  return fmt::format("{} to {}", bound_text(variable.low), bound_text(variable.high));
}

std::string shape_text(const Variable& variable) {
  if (variable.rank == 0) return std::string(variable.name);
  if (variable.rank == 1) return fmt::format("{}({})", variable.name, variable.n1);
  return fmt::format("{}({},{})", variable.name, variable.n1, variable.n2);
}

std::string value_text(const DeckValue& value) { return std::visit(ValueText{}, value.data); }

namespace {

constexpr std::size_t longest_name = 40;  // nothing in the table is near a longer one
constexpr std::size_t short_name = 3;     // two changes make any other word of it

std::size_t changes_allowed(const std::string& name) { return name.size() <= short_name ? 1 : 2; }

std::vector<std::string> names_of(const std::string& group) {
  std::vector<std::string> names;
  for (const auto& variable : variables()) {
    if (group.empty() || variable.group == group) names.emplace_back(variable.name);
  }
  return names;
}

std::string group_of(const std::string& name) {
  for (const auto& variable : variables()) {
    if (variable.name == name) return std::string(variable.group);
  }
  return "";
}

/// What other codes call something, and what it is called here: the first that stands in the group, or else the first.
struct Synonym {
  std::string_view names;  // between blanks
  std::array<std::string_view, 3> here;
  std::string_view note;
};

constexpr std::array synonyms{
    Synonym{" dt timestep time_step deltat delta_t stepsize step_size ", {"in.tstep"}, ""},
    Synonym{
        " tend t_end endtime end_time tfinal t_final final_time stop_time stoptime tstop duration ", {"in.tmax"}, ""},
    Synonym{" dx dy h cellsize cell_size spacing ", {"in.nx", "in.ny"}, "a cell is (xright - xleft)/(nx - 1) wide"},
    Synonym{" ncells nelx ncx ", {"in.nx"}, "it counts nodes, one more than cells"},
    Synonym{" xmin x_min x0 xlo ", {"in.xleft"}, ""},
    Synonym{" xmax x_max x1 xhi ", {"in.xright"}, ""},
    Synonym{" ymin y_min y0 ylo ", {"in.ybot"}, ""},
    Synonym{" ymax y_max y1 yhi ", {"in.ytop"}, ""},
    Synonym{" g gravity grav gy ", {"in.gravc"}, ""},
    Synonym{" dtout dt_out tout output_interval dt_output plot_interval ",
            {"in.tiout"},
            "tiout(i) is the interval of output i"},
    Synonym{" rho density dens rho0 ", {"reg.densir", "membrane.density", "flow.density"}, ""},
    Synonym{" e emod e_mod young youngs young_modulus youngs_modulus ym modulus ",
            {"reg.matr", "membrane.young"},
            "matr(1,r) is Young's modulus of region r"},
    Synonym{" nu poisson poissons poisson_ratio poissons_ratio pr ",
            {"reg.matr", "membrane.poisson"},
            "matr(2,r) is Poisson's ratio of region r"},
    Synonym{" material mat law model constitutive ", {"reg.ipath"}, "ipath(4,r) is the law of region r"},
    Synonym{" ppc points_per_cell particles_per_cell ppe ", {"reg.nprg"}, ""},
    Synonym{" vx u0 vx0 velocity_x ", {"reg.vrx"}, ""},
    Synonym{" vy v0 vy0 velocity_y ", {"reg.vry"}, ""},
    Synonym{" gamma ", {"fluid.gm1"}, "gm1 is gamma - 1"},
    Synonym{" viscosity visc eta ", {"fluid.mu", "flow.viscosity", "coupled.viscosity"}, ""},
    Synonym{" courant cfl_number ", {"mpm.cfl", "fem.cfl"}, ""},
};

const Synonym* find_synonym(const std::string& name) {
  const auto known = std::find_if(synonyms.begin(), synonyms.end(), [&name](const Synonym& synonym) {
    return synonym.names.find(" " + name + " ") != std::string_view::npos;
  });
  return known == synonyms.end() ? nullptr : &*known;
}

/// "group.name" of what is meant in this group, or else first.
std::string_view meant_by(const Synonym& synonym, const std::string& group) {
  const auto there = std::find_if(synonym.here.begin(), synonym.here.end(), [&group](std::string_view full) {
    return !full.empty() && full.substr(0, full.find('.')) == group;
  });
  return there == synonym.here.end() ? synonym.here[0] : *there;
}

/// "It is 'tstep' (group $in) here."
std::string text_of(const Synonym& synonym, const std::string& group) {
  const auto meant = meant_by(synonym, group);
  const auto dot = meant.find('.');
  const bool noted = meant == synonym.here[0] && !synonym.note.empty();
  return fmt::format("It is '{}' (group ${}) here{}{}.", meant.substr(dot + 1), meant.substr(0, dot), noted ? ": " : "",
                     noted ? synonym.note : "");
}

/// The nearest name of the group, or else of all.
std::string near_variable(const std::string& group, const std::string& name) {
  const auto near = nearest_name(name, names_of(group), changes_allowed(name));
  if (!near.empty()) return group.empty() ? group_of(near) + "." + near : group + "." + near;
  const auto elsewhere = nearest_name(name, names_of(""), changes_allowed(name));
  return elsewhere.empty() ? "" : group_of(elsewhere) + "." + elsewhere;
}

}  // namespace

std::string suggest_variable(const std::string& group, const std::string& name) {
  if (name.size() > longest_name) return "";
  if (const auto* synonym = find_synonym(name)) return text_of(*synonym, group);
  const auto owner = group_of(name);
  if (!owner.empty()) return fmt::format("'{}' belongs to group ${}.", name, owner);
  const auto near = near_variable(group, name);
  const auto dot = near.find('.');
  return near.empty() ? "" : fmt::format("Did you mean '{}' (group ${})?", near.substr(dot + 1), near.substr(0, dot));
}

std::string meant_variable(const std::string& group, const std::string& name) {
  if (name.size() > longest_name) return "";
  if (const auto* synonym = find_synonym(name)) return std::string(meant_by(*synonym, group));
  const auto owner = group_of(name);
  return owner.empty() ? near_variable(group, name) : owner + "." + name;
}

std::string suggest_group(const std::string& name) {
  const auto groups = group_names();
  const auto near = name.size() > longest_name ? "" : nearest_name(name, groups);
  if (!near.empty()) return fmt::format("Did you mean '${}'?", near);
  std::string all;
  for (const auto& group : groups) all += (all.empty() ? "$" : ", $") + group;
  return fmt::format("The groups are {}.", all);
}

}  // namespace tether
