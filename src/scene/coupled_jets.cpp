// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "scene/coupled_of_deck.hpp"
#include "scene/named_sides.hpp"
#include "scene/solids_of_deck.hpp"

namespace tether {
namespace {

/// Reads one jet.
class JetReader {
 public:
  JetReader(const Deck& deck, int k, const Coupled& coupled, Diagnostics& diagnostics)
      : deck_(deck), k_(k), coupled_(coupled), diagnostics_(diagnostics) {}

  Jet read() {
    Jet jet;
    jet.number = k_;
    const auto side = std::find(box_side_names.begin(), box_side_names.end(), deck_.text("coupled", "jet_on", k_));
    jet.side = static_cast<int>(side - box_side_names.begin());
    if (axis_of_side(jet.side) < coupled_.grid.dim) {
      jet.patch = patch_of(jet.side);
    } else {
      error("jet_on", {k_, 1}, fmt::format("jet {} is on the {}, but the box is plane", k_, *side),
            "with nz, zback and zfront of $coupled there is a back and a front");
    }
    if (!deck_.given("coupled", "jet_speed", k_)) {
      error("jet_on", {k_, 1}, fmt::format("jet {} has no speed: jet_speed({}) is not given", k_, k_),
            "it is positive into the box");
    } else {
      jet.speed = deck_.real("coupled", "jet_speed", k_);
    }
    jet.amplitude = amplitude_of(deck_, "coupled", "jet", k_, diagnostics_);
    jet.smoke = deck_.real("coupled", "jet_smoke", k_);
    jet.temperature = deck_.real("coupled", "jet_temperature", k_);
    return jet;
  }

 private:
  void error(const char* name, Subscript at, const std::string& message, const std::string& hint) {
    diagnostics_.add(deck_.remark(Severity::error, "coupled", name, at, message, hint));
  }
  AxisBox patch_of(int side) {
    const StaggeredGrid& grid = coupled_.grid;
    AxisBox patch;
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
  /// From low to high, the side's ends, narrower where the deck says so.
  void read_extent(int first, double& low, double& high) {
    const bool given = deck_.given("coupled", "jet", first, k_);
    if (given != deck_.given("coupled", "jet", first + 1, k_)) {
      const int there = given ? first : first + 1, other = given ? first + 1 : first;
      error("jet", {there, k_}, fmt::format("jet({},{}) is not given, but jet({},{}) is", other, k_, there, k_),
            "a jet has a lowest and a highest place along an axis, or all of the side");
      return;
    }
    if (!given) return;
    const double a = deck_.real("coupled", "jet", first, k_), b = deck_.real("coupled", "jet", first + 1, k_);
    const double slack = 1e-9 * (high - low);
    if (!(b > a)) {
      error("jet", {first + 1, k_}, fmt::format("jet {}: {:.6g} is not above {:.6g}", k_, b, a), "the lowest first");
    } else if (a < low - slack || b > high + slack) {
      error("jet", {first, k_},
            fmt::format("jet {} from {:.6g} to {:.6g} is not within its side, {:.6g} to {:.6g}", k_, a, b, low, high),
            "places are along x, y, z less the axis across the side");
    }
    low = a, high = b;
  }

  const Deck& deck_;
  int k_;
  const Coupled& coupled_;
  Diagnostics& diagnostics_;
};

}  // namespace

void add_jets(const Deck& deck, Coupled& coupled, Diagnostics& diagnostics) {
  check_all_act(deck, "coupled", "jet", "jet_on",
                {"jet", "jet_speed", "jet_time", "jet_factor", "jet_expression", "jet_smoke", "jet_temperature"},
                diagnostics);
  for (const Subscript at : deck.given_elements("coupled", "jet_on")) {
    coupled.jets.push_back(JetReader(deck, at[0], coupled, diagnostics).read());
    const Jet& jet = coupled.jets.back();
    coupled.smoke |= jet.smoke != 0 || jet.temperature != 0;
  }
}

}  // namespace tether
