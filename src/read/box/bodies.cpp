// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "read/box/coupled_of_deck.hpp"
#include "read/mesh/named_sides.hpp"

namespace tether {
namespace {

void refuse(const Deck& deck, const char* name, Subscript at, const std::string& message, const std::string& hint,
            Diagnostics& diagnostics) {
  diagnostics.add(deck.remark(Severity::error, "coupled", name, at, message, hint));
}

std::vector<int> without_twins(std::vector<int> nodes) {
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/// Nodes of the elements of a region, from 0.
std::vector<int> nodes_of_region(const Mesh& mesh, int region) {
  std::vector<int> nodes;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    if (mesh.region[e] == region)
      nodes.insert(nodes.end(), mesh.element(e), mesh.element(e) + node_count_of(mesh.kind));
  }
  return without_twins(std::move(nodes));
}

/// What spring_on(k) names, which is told where there is nothing of that name.
std::vector<int> nodes_named(const Deck& deck, int k, const Solids& solids, Diagnostics& diagnostics) {
  const std::string on = deck.text("coupled", "spring_on", k);
  if (!on.starts_with("region ")) {
    const Sides* sides = named_sides(deck, "coupled", "spring_on", k, solids.mesh, diagnostics);
    return sides ? without_twins(*sides) : std::vector<int>{};
  }
  for (std::size_t r = 0; r < solids.regions.size(); ++r) {
    if (solids.regions[r].name == on) return nodes_of_region(solids.mesh, static_cast<int>(r));
  }
  refuse(deck, "spring_on", {k, 1}, fmt::format("there is no {}", on), "regions are 1 to nreg", diagnostics);
  return {};
}

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

/// Tells of a hinge on a node that a support moves elsewhere.
void check_moved(const Deck& deck, int k, const Support& hinge, const Solids& solids, Diagnostics& diagnostics) {
  for (const Support& other : solids.supports) {
    bool moves = false;
    for (std::size_t i = 0; i < 3; ++i) moves |= other.fixed[i] && other.displacement[i] != 0;
    const bool same = std::any_of(hinge.nodes.begin(), hinge.nodes.end(), [&](int node) {
      return std::binary_search(other.nodes.begin(), other.nodes.end(), node);
    });
    if (!moves || !same) continue;
    refuse(deck, "hinge", {1, k}, fmt::format("hinge {} holds a node that {} moves", k, other.amplitude.of),
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
  check_all_act(deck, "coupled", "spring", "spring_on", {"spring"}, diagnostics);
  for (const Subscript at : deck.given_elements("coupled", "spring_on")) {
    Spring spring;
    spring.number = at[0];
    spring.nodes = nodes_named(deck, at[0], solids, diagnostics);
    for (int i = 1; i <= 3; ++i)
      spring.stiffness[static_cast<std::size_t>(i - 1)] = deck.real("coupled", "spring", i, at[0]);
    if (spring.stiffness == std::array<double, 3>{})
      refuse(deck, "spring_on", at, fmt::format("spring {} has no stiffness: spring(1,{}) is not given", at[0], at[0]),
             "write its stiffness in x, y and z, force per length", diagnostics);
    if (solids.mesh.dim() == 2 && spring.stiffness[2] != 0)
      refuse(deck, "spring", {3, at[0]}, fmt::format("spring {} acts along z, but the mesh is plane", at[0]),
             "leave its third stiffness away", diagnostics);
    coupled.springs.push_back(std::move(spring));
  }
}

void add_hinges(const Deck& deck, Solids& solids, Diagnostics& diagnostics) {
  std::set<int> numbers;
  for (const Subscript at : deck.given_elements("coupled", "hinge")) numbers.insert(at[1]);
  for (const int k : numbers) {
    const bool x = deck.given("coupled", "hinge", 1, k), y = deck.given("coupled", "hinge", 2, k);
    if (!x || !y) {
      refuse(deck, "hinge",
             {x   ? 1
              : y ? 2
                  : 3,
              k},
             fmt::format("hinge {} has no {}", k, x ? "y" : "x"), "a hinge has x and y", diagnostics);
      continue;
    }
    Support support;
    support.nodes = nodes_in_line(solids.mesh, nearest_node(solids.mesh, deck.real("coupled", "hinge", 1, k),
                                                            deck.real("coupled", "hinge", 2, k)));
    support.fixed = {true, true, solids.mesh.dim() == 3};
    support.amplitude.of = fmt::format("hinge {}", k);
    check_moved(deck, k, support, solids, diagnostics);
    solids.supports.push_back(std::move(support));
  }
}

}  // namespace tether
