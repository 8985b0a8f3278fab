// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/vec.hpp"

namespace tether {

/// Places that are sums of a mesh's nodes with fixed shares, or fixed themselves: linear in the nodes' places, so that
/// a force on one is a force on its nodes, and nothing is lost on the way.
struct CarriedPlaces {
  int dim = 2;
  std::vector<std::size_t> start{0};
  std::vector<int> node;
  std::vector<double> share;
  std::vector<double> fixed;  ///< dim numbers a place, 0 of carried ones [length]

  std::size_t size() const { return start.size() - 1; }
  bool is_fixed(int place) const {
    return start[static_cast<std::size_t>(place)] == start[static_cast<std::size_t>(place) + 1];
  }
  std::span<const int> nodes(int place) const;
  std::span<const double> shares(int place) const;
  /// Adds a place carried by nodes, those without a share left out; returns its number.
  int add(std::span<const int> nodes, std::span<const double> shares);
  int add_fixed(const Vec<3>& place);
  /// Finds where they are with the nodes at q; x has dim numbers a place.
  void find(std::span<const double> q, std::vector<double>& x) const;
  /// Adds forces on the places, `dim` numbers each, to those of the nodes that carry them.
  void add_to_nodes(std::span<const double> forces, std::span<double> f) const;
};

}  // namespace tether
