// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/automatic/refinement.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace tether::automatic {
namespace {

/// Fewer cells than these across say no more of what is across: a strip of one cell stays one.
constexpr int least_cells_refined = 2;

/// A fluid in a box has no fewer cells across.
constexpr int least_cells_of_a_box = 2;

double cells_of(const Refined& value) { return value.as == Refined::As::nodes ? value.own - 1 : value.own; }

/// How many cells a count comes to.
double refined_cells(const Refined& value, double factor) {
  const double least = std::min<double>(value.least, cells_of(value));
  return std::max(least, std::round(cells_of(value) * factor));
}

bool is_count(const Refined& value) { return value.as == Refined::As::cells || value.as == Refined::As::nodes; }

std::string override_of(const Refined& value, double factor) {
  if (!is_count(value)) return fmt::format("{}={:.17g}", value.element, value.own / factor);
  const auto count = static_cast<long long>(refined_cells(value, factor));
  return fmt::format("{}={}", value.element, value.as == Refined::As::nodes ? count + 1 : count);
}

bool moves_in_time(const Deck& deck) { return !deck.logical("fem.static") && !deck.logical("flow.steady"); }

/// Curved edges, which straight elements only come near.
bool has_curved_edges(const Deck& deck) {
  for (const auto& at : deck.given_elements("mesh.edge")) {
    if (deck.text("mesh.edge", at[0], at[1]) != "line") return true;
  }
  return false;
}

}  // namespace

Refinement::Refinement(const Deck& deck, const Scene& scene) {
  const bool by_grid = scene.path() == Path::mpm || scene.coupled() != nullptr;
  if (by_grid) add_grid(deck, scene);
  of_a_grid_ = by_grid && deck.text("coupled.flow") == "grid";
  // The mesh of a rigid body gives it its mass alone, which straight elements give exactly.
  const bool by_mesh = scene.solids() != nullptr || scene.flow() != nullptr;
  if (!scene.rigid() || has_curved_edges(deck)) add_elements(deck, by_mesh);
  if (!by_mesh) add_strings(deck);
  if (moves_in_time(deck)) add_steps(deck);
  const double cfl = scene.clock.cfl;
  if (scene.path() == Path::mpm && cfl > 0) limit_ = {"mpm.cfl", Refined::As::time, cfl};
}

void Refinement::add_grid(const Deck& deck, const Scene& scene) {
  int directions = 0;
  for (const AnyVariable name : Variables{"in.nx", "in.ny", "coupled.nz"}) {
    if (!deck.given(name)) continue;
    const int nodes = deck.integer(IntegerVariable(name));
    if (nodes - 1 < least_cells_refined) continue;
    space_.push_back({fmt::format("{}.{}", name.group(), name.name()), Refined::As::nodes, static_cast<double>(nodes),
                      scene.coupled() ? least_cells_of_a_box : 1});
    ++directions;
  }
  dimensions_ = std::max(dimensions_, directions);
  if (!scene.coupled()) return;
  for (const RealVariable name : {RealVariable("coupled.size"), RealVariable("coupled.size_near")}) {
    if (deck.given(name))
      space_.push_back({fmt::format("{}.{}", name.group(), name.name()), Refined::As::length, deck.real(name)});
  }
}

/// A direction in which the deck counts no cells has one, and keeps it.
void Refinement::add_elements(const Deck& deck, bool are_of_own_way) {
  if (!deck.text("mesh.file").empty()) return;
  std::set<int> regions;
  for (const auto& at : deck.given_elements("mesh.cells")) regions.insert(at[1]);
  std::set<int> directions;
  for (const int r : regions) {
    for (int a = 1; a <= 3; ++a) {
      const int count = deck.integer("mesh.cells", a, r);
      if (!deck.given("mesh.cells", a, r) && count == 1) continue;
      elements_.push_back({fmt::format("mesh.cells({},{})", a, r), Refined::As::cells, static_cast<double>(count)});
      directions.insert(a);
    }
  }
  if (!are_of_own_way) return;
  space_.insert(space_.end(), elements_.begin(), elements_.end());
  dimensions_ = std::max(dimensions_, static_cast<int>(directions.size()));
}

void Refinement::add_strings(const Deck& deck) {
  for (const auto& at : deck.given_elements("membrane.count"))
    space_.push_back({fmt::format("membrane.count({})", at[0]), Refined::As::cells,
                      static_cast<double>(deck.integer("membrane.count", at[0]))});
  for (const auto& at : deck.given_elements("membrane.spacing"))
    space_.push_back(
        {fmt::format("membrane.spacing({})", at[0]), Refined::As::length, deck.real("membrane.spacing", at[0])});
}

void Refinement::add_steps(const Deck& deck) {
  for (const RealVariable name : {RealVariable("in.tstep"), RealVariable("in.dtmax")}) {
    if (deck.given(name))
      time_.push_back({fmt::format("{}.{}", name.group(), name.name()), Refined::As::time, deck.real(name)});
  }
}

std::vector<std::string> Refinement::overrides(const Resolution& wanted, Way way, double stretch) const {
  std::vector<std::string> all;
  for (const Refined& value : space(way)) all.push_back(override_of(value, wanted.space));
  for (const Refined& value : time_) all.push_back(override_of(value, wanted.time / stretch));
  if (limit_ && way == Way::own && stretch != 1) all.push_back(override_of(*limit_, 1 / stretch));
  return all;
}

Resolution Refinement::rounded(const Resolution& wanted, Way way) const {
  const std::vector<Refined>& values = space(way);
  double sum = 0;
  for (const Refined& value : values)
    sum += std::log(is_count(value) ? refined_cells(value, wanted.space) / cells_of(value) : wanted.space);
  return {values.empty() ? 1 : std::exp(sum / static_cast<double>(values.size())), wanted.time};
}

double Refinement::fineness(double step) const {
  double own = std::numeric_limits<double>::infinity();
  for (const Refined& value : time_) own = std::min(own, value.own);
  return time_.empty() ? 1 : own / step;
}

namespace {

double order_of_elements(const std::string& element) { return element.find('2') == std::string::npos ? 2 : 3; }

double space_order(const Deck& deck, const Scene& scene) {
  if (scene.flow()) return deck.text("flow.element") == "q1q1" ? 2 : 3;
  if (scene.coupled()) return 2;  // cut cells, and P1 elements
  if (scene.solids()) return scene.solids()->contact ? 1 : order_of_elements(deck.text("mesh.element"));
  return 1;  // points in cells, and points that stand for pieces of a string
}

double time_order(const Deck& deck, const Scene& scene) {
  if (scene.flow()) return deck.text("flow.integrator") == "euler" ? 1 : 2;
  if (scene.coupled()) return deck.text("coupled.integrator") == "paper" ? 1 : 2;
  if (scene.solids()) return scene.solids()->contact ? 1 : 2;
  return 1;
}

}  // namespace

Orders theory_of(const Deck& deck, const Scene& scene, const Refinement& refinement, Way way) {
  Orders orders;
  const bool is_own = way == Way::own;
  if (is_own ? refinement.in_space() : refinement.has_elements())
    orders.space = is_own ? space_order(deck, scene) : order_of_elements(deck.text("mesh.element"));
  if (refinement.in_time()) orders.time = is_own ? time_order(deck, scene) : 2;
  return orders;
}

}  // namespace tether::automatic
