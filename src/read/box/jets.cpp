// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "read/amplitude_of_deck.hpp"
#include "read/box/coupled_of_deck.hpp"
#include "read/mesh/named_sides.hpp"

namespace tether {
namespace {

/// Reads the part of a side that a jet or an opening is: `name` is the deck's variable of its places.
class PatchReader {
 public:
  PatchReader(const Deck& deck, const char* name, int k, const Coupled& coupled, Diagnostics& diagnostics)
      : deck_(deck), name_(name), k_(k), coupled_(coupled), diagnostics_(diagnostics) {}

  int side() const {
    const auto side = std::find(box_side_names.begin(), box_side_names.end(), deck_.text("coupled", on(), k_));
    return static_cast<int>(side - box_side_names.begin());
  }
  AxisBox patch_of(int side) {
    const StaggeredGrid& grid = coupled_.grid;
    AxisBox patch;
    if (axis_of_side(side) >= grid.dim) {
      error(
          on(), {k_, 1},
          fmt::format("{} is on the {}, but the box is plane", what(), box_side_names[static_cast<std::size_t>(side)]),
          "with nz, zback and zfront of $coupled there is a back and a front");
      return patch;
    }
    int first = 1;  // of the deck's places along an axis
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      patch.low[i] = grid.low[i], patch.high[i] = grid.high(axis);
      if (axis == axis_of_side(side)) {
        patch.low[i] = patch.high[i] = is_low_side(side) ? patch.low[i] : patch.high[i];
      } else if (axis < grid.dim) {
        read_extent(first, patch.low[i], patch.high[i]);
        first += 2;
      }
    }
    return patch;
  }
  std::string on() const { return std::string(name_) + "_on"; }
  /// "jet 2" or "opening 1".
  std::string what() const { return fmt::format("{} {}", name_ == std::string_view("jet") ? "jet" : "opening", k_); }
  void error(const std::string& name, Subscript at, const std::string& message, const std::string& hint) {
    diagnostics_.add(deck_.remark(Severity::error, "coupled", name, at, message, hint));
  }

 private:
  /// From low to high, the side's ends, narrower where the deck says so.
  void read_extent(int first, double& low, double& high) {
    const bool given = deck_.given("coupled", name_, first, k_);
    if (given != deck_.given("coupled", name_, first + 1, k_)) {
      const int there = given ? first : first + 1, other = given ? first + 1 : first;
      error(name_, {there, k_}, fmt::format("{0}({1},{2}) is not given, but {0}({3},{2}) is", name_, other, k_, there),
            "it has a lowest and a highest place along an axis, or all of the side");
      return;
    }
    if (!given) return;
    const double a = deck_.real("coupled", name_, first, k_), b = deck_.real("coupled", name_, first + 1, k_);
    const double slack = 1e-9 * (high - low);
    if (!(b > a)) {
      error(name_, {first + 1, k_}, fmt::format("{}: {:.6g} is not above {:.6g}", what(), b, a), "the lowest first");
    } else if (a < low - slack || b > high + slack) {
      error(name_, {first, k_},
            fmt::format("{} from {:.6g} to {:.6g} is not within its side, {:.6g} to {:.6g}", what(), a, b, low, high),
            "places are along x, y, z less the axis across the side");
    }
    low = a, high = b;
  }

  const Deck& deck_;
  const char* name_;
  int k_;
  const Coupled& coupled_;
  Diagnostics& diagnostics_;
};

Jet jet_of(const Deck& deck, int k, const Coupled& coupled, Diagnostics& diagnostics) {
  PatchReader reader(deck, "jet", k, coupled, diagnostics);
  Jet jet;
  jet.number = k;
  jet.side = reader.side();
  jet.patch = reader.patch_of(jet.side);
  if (!deck.given("coupled", "jet_speed", k)) {
    reader.error("jet_on", {k, 1}, fmt::format("jet {} has no speed: jet_speed({}) is not given", k, k),
                 "it is positive into the box");
  } else {
    jet.speed = deck.real("coupled", "jet_speed", k);
  }
  jet.amplitude = amplitude_of(deck, "coupled", "jet", k, diagnostics);
  jet.smoke = deck.real("coupled", "jet_smoke", k);
  jet.temperature = deck.real("coupled", "jet_temperature", k);
  return jet;
}

}  // namespace

void add_jets(const Deck& deck, Coupled& coupled, Diagnostics& diagnostics) {
  check_all_act(deck, "coupled", "jet", "jet_on",
                {"jet", "jet_speed", "jet_time", "jet_factor", "jet_expression", "jet_smoke", "jet_temperature"},
                diagnostics);
  for (const Subscript at : deck.given_elements("coupled", "jet_on")) {
    coupled.jets.push_back(jet_of(deck, at[0], coupled, diagnostics));
    const Jet& jet = coupled.jets.back();
    coupled.smoke |= jet.smoke != 0 || jet.temperature != 0;
  }
}

void add_openings(const Deck& deck, Coupled& coupled, Diagnostics& diagnostics) {
  check_all_act(deck, "coupled", "open", "open_on", {"open"}, diagnostics);
  for (const Subscript at : deck.given_elements("coupled", "open_on")) {
    PatchReader reader(deck, "open", at[0], coupled, diagnostics);
    Opening opening;
    opening.number = at[0];
    opening.side = reader.side();
    opening.patch = reader.patch_of(opening.side);
    if (coupled.sides[static_cast<std::size_t>(opening.side)] != BoxSide::wall)
      diagnostics.add(deck.remark(Severity::warning, "coupled", "open_on", at,
                                  fmt::format("opening {} has no effect: all of that side is open", opening.number),
                                  fmt::format("leave side({}) away", opening.side + 1)));
    coupled.openings.push_back(opening);
  }
}

}  // namespace tether
