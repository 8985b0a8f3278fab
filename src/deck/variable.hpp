// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/diagnostics.hpp"

namespace tether {

/// One value of the deck and where it was written.
struct DeckValue {
  std::variant<long long, double, bool, std::string> data;
  Place place;
};

enum class ValueType { integer, real, logical, text };

/// What a value does: it is used, or it is read for the sake of old decks and has no effect.
enum class Effect { used, none };

/// A row of THE table of deck variables, from which the reader, `tether vars`, `tether check`, `deck.effective` and
/// decks/guide/variables are all made.
struct Variable {
  std::string_view group, name;
  ValueType type;
  int rank;                   ///< 0 a scalar, 1 name(n1), 2 name(n1, n2)
  int n1, n2;                 ///< declared shape, column-major; 1 where the rank does not reach
  std::string_view unit;      ///< dimension in words: "length", "mass/length3", "" for a pure number
  double low, high;           ///< range of numbers, both ends allowed
  std::string_view choices;   ///< texts: "musl|usf|usl", empty for any; integers: the allowed ones "0|1|4|5|6"
  std::string_view fallback;  ///< the default, as a deck would write it ("0.0", ".true.", "'musl'"); "" : none
  std::string_view meaning;   ///< one sentence
  Effect effect = Effect::used;
  bool required = false;  ///< a deck must give it
};

/// The group of study decks, which have no other.
constexpr std::string_view study_group = "study";
/// The group of published numbers, which says nothing to the run itself.
constexpr std::string_view published_group = "published";
/// The group of what a search for the cheapest setting is after, which says nothing to the run itself either.
constexpr std::string_view auto_group = "auto";
/// Returns whether a group is for those who make runs, and not for the run.
constexpr bool is_about_runs(std::string_view group) { return group == published_group || group == auto_group; }

// Sizes of the old code's arrays.
constexpr int region_count = 20;       ///< regions
constexpr int vertex_count = 20;       ///< vertices of a region
constexpr int output_count = 60;       ///< switches iout, tiout
constexpr int point_count = 100000;    ///< rows of a particle file that can be singled out
constexpr int tracked_at_count = 100;  ///< places in tracked_at
constexpr int membrane_count = 10;     ///< membranes
constexpr int curve_count = 40;        ///< curves of all membranes
constexpr int curve_vertex_count = 100;
constexpr int load_count = 40;   ///< loads, and supports, of a mesh
constexpr int table_count = 50;  ///< times of one of them

namespace bounds {
constexpr double none = std::numeric_limits<double>::infinity();
constexpr double above_zero = std::numeric_limits<double>::denorm_min();  ///< stands for "> 0"
constexpr double largest_integer = 2147483647;
constexpr double smallest_integer = -2147483648.0;
}  // namespace bounds

}  // namespace tether
