// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>

#include "base/vec.hpp"
#include "read/box/box.hpp"
#include "read/mesh/sides.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

/// The used node nearest to x, y.
std::size_t nearest_node(const Mesh& mesh, double x, double y) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    const double away = std::hypot(mesh.x[n * dim] - x, mesh.x[n * dim + 1] - y);
    if (away < least) least = away, nearest = n;
  }
  return nearest;
}

/// Reports a hinge on a node that a support moves elsewhere.
void check_moved(const Deck& deck, int k, const Support& hinge, const Solids& solids, Diagnostics& diagnostics) {
  for (const Support& other : solids.supports) {
    bool moves = false;
    for (std::size_t i = 0; i < 3; ++i) moves |= other.fixed[i] && other.displacement[i] != 0;
    const bool same = std::any_of(hinge.nodes.begin(), hinge.nodes.end(), [&](int node) {
      return std::binary_search(other.nodes.begin(), other.nodes.end(), node);
    });
    if (!moves || !same) continue;
    refuse(deck, "coupled.hinge", {1, k}, fmt::format("hinge {} holds a node that {} moves", k, other.amplitude.of),
           "leave one of them away", diagnostics);
  }
}

/// All nodes at the x and y of one of them.
std::vector<int> nodes_in_line(const Mesh& mesh, std::size_t node) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  const double* at = &mesh.x[node * dim];
  const double slack = 1e-9 * (1 + std::hypot(at[0], at[1]));
  std::vector<int> nodes;
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    if (std::hypot(mesh.x[n * dim] - at[0], mesh.x[n * dim + 1] - at[1]) <= slack) nodes.push_back(static_cast<int>(n));
  }
  return nodes;
}

}  // namespace

void add_springs(const Deck& deck, const Solids& solids, Coupled& coupled, Diagnostics& diagnostics) {
  check_all_act(deck, "spring", "coupled.spring_on", {"coupled.spring"}, diagnostics);
  for (const Subscript at : deck.given_elements("coupled.spring_on")) {
    Spring spring;
    spring.number = at[0];
    spring.nodes = named_nodes(deck, "coupled.spring_on", at[0], solids, diagnostics);
    for (int i = 1; i <= 3; ++i)
      spring.stiffness[static_cast<std::size_t>(i - 1)] = deck.real("coupled.spring", i, at[0]);
    if (spring.stiffness == Vec<3>{})
      refuse(deck, "coupled.spring_on", at,
             fmt::format("spring {} has no stiffness: spring(1,{}) is not given", at[0], at[0]),
             "write its stiffness in x, y and z, force per length", diagnostics);
    if (solids.mesh.dim() == 2 && spring.stiffness[2] != 0)
      refuse(deck, "coupled.spring", {3, at[0]}, fmt::format("spring {} acts along z, but the mesh is plane", at[0]),
             "leave its third stiffness away", diagnostics);
    coupled.springs.push_back(std::move(spring));
  }
}

void add_hinges(const Deck& deck, Solids& solids, Diagnostics& diagnostics) {
  std::set<int> numbers;
  for (const Subscript at : deck.given_elements("coupled.hinge")) numbers.insert(at[1]);
  for (const int k : numbers) {
    const bool x = deck.given("coupled.hinge", 1, k), y = deck.given("coupled.hinge", 2, k);
    if (!x || !y) {
      refuse(deck, "coupled.hinge",
             {x   ? 1
              : y ? 2
                  : 3,
              k},
             fmt::format("hinge {} has no {}", k, x ? "y" : "x"), "a hinge has x and y", diagnostics);
      continue;
    }
    Support support;
    support.nodes = nodes_in_line(
        solids.mesh, nearest_node(solids.mesh, deck.real("coupled.hinge", 1, k), deck.real("coupled.hinge", 2, k)));
    support.fixed = {true, true, solids.mesh.dim() == 3};
    support.amplitude.of = fmt::format("hinge {}", k);
    check_moved(deck, k, support, solids, diagnostics);
    solids.supports.push_back(std::move(support));
  }
}

namespace {

/// Reads the part of a side that a jet or an opening is: `name` is the deck's variable of its places.
class PatchReader {
 public:
  PatchReader(const Deck& deck, RealVariable name, int k, const Coupled& coupled, Diagnostics& diagnostics)
      : deck_(deck), name_(name), k_(k), coupled_(coupled), diagnostics_(diagnostics) {}

  int side() const {
    const auto side = std::find(box_side_names.begin(), box_side_names.end(), deck_.text(on(), k_));
    return static_cast<int>(side - box_side_names.begin());
  }
  Box<3> patch_of(int side) {
    const StaggeredGrid& grid = coupled_.grid;
    Box<3> patch;
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
  AnyVariable on() const { return name_.with("_on"); }
  /// "jet 2" or "opening 1".
  std::string what() const { return fmt::format("{} {}", name_ == "coupled.jet" ? "jet" : "opening", k_); }
  void error(AnyVariable name, Subscript at, const std::string& message, const std::string& hint) {
    diagnostics_.add(deck_.remark(Severity::error, name, at, message, hint));
  }

 private:
  /// From low to high, the side's ends, narrower where the deck says so.
  void read_extent(int first, double& low, double& high) {
    const bool given = deck_.given(name_, first, k_);
    if (given != deck_.given(name_, first + 1, k_)) {
      const int there = given ? first : first + 1, other = given ? first + 1 : first;
      error(name_, {there, k_}, fmt::format("{0}({1},{2}) is not given, but {0}({3},{2}) is", name_, other, k_, there),
            "it has a lowest and a highest place along an axis, or all of the side");
      return;
    }
    if (!given) return;
    const double a = deck_.real(name_, first, k_), b = deck_.real(name_, first + 1, k_);
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
  RealVariable name_;
  int k_;
  const Coupled& coupled_;
  Diagnostics& diagnostics_;
};

Jet jet_of(const Deck& deck, int k, const Coupled& coupled, Diagnostics& diagnostics) {
  PatchReader reader(deck, "coupled.jet", k, coupled, diagnostics);
  Jet jet;
  jet.number = k;
  jet.side = reader.side();
  jet.patch = reader.patch_of(jet.side);
  if (!deck.given("coupled.jet_speed", k)) {
    reader.error("coupled.jet_on", {k, 1}, fmt::format("jet {} has no speed: jet_speed({}) is not given", k, k),
                 "it is positive into the box");
  } else {
    jet.speed = deck.real("coupled.jet_speed", k);
  }
  jet.amplitude = amplitude_of(deck, "coupled.jet", k, diagnostics);
  jet.smoke = deck.real("coupled.jet_smoke", k);
  jet.temperature = deck.real("coupled.jet_temperature", k);
  return jet;
}

}  // namespace

void add_jets(const Deck& deck, Coupled& coupled, Diagnostics& diagnostics) {
  check_all_act(deck, "jet", "coupled.jet_on",
                {"coupled.jet", "coupled.jet_speed", "coupled.jet_time", "coupled.jet_factor", "coupled.jet_expression",
                 "coupled.jet_smoke", "coupled.jet_temperature"},
                diagnostics);
  for (const Subscript at : deck.given_elements("coupled.jet_on")) {
    coupled.jets.push_back(jet_of(deck, at[0], coupled, diagnostics));
    const Jet& jet = coupled.jets.back();
    coupled.smoke |= jet.smoke != 0 || jet.temperature != 0;
  }
}

void add_openings(const Deck& deck, Coupled& coupled, Diagnostics& diagnostics) {
  check_all_act(deck, "open", "coupled.open_on", {"coupled.open"}, diagnostics);
  for (const Subscript at : deck.given_elements("coupled.open_on")) {
    PatchReader reader(deck, "coupled.open", at[0], coupled, diagnostics);
    Opening opening;
    opening.number = at[0];
    opening.side = reader.side();
    opening.patch = reader.patch_of(opening.side);
    if (!is_wall(coupled.sides[static_cast<std::size_t>(opening.side)]))
      diagnostics.add(deck.remark(Severity::warning, "coupled.open_on", at,
                                  fmt::format("opening {} has no effect: all of that side is open", opening.number),
                                  fmt::format("leave side({}) away", opening.side + 1)));
    coupled.openings.push_back(opening);
  }
}

}  // namespace tether
