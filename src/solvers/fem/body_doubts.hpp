// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "grid/background_grid.hpp"
#include "model/solids.hpp"
#include "solvers/fem/told_doubts.hpp"

namespace tether::fem {

/// Looks whether bodies go on where the model does not hold any more: beyond the grid, where nothing stops them, or
/// turned further than a linear law follows. Each is reported once. The solids and the grid must outlive it.
class BodyDoubts {
 public:
  BodyDoubts(const Solids& solids, const BackgroundGrid& grid);

  void look(std::span<const double> q, double time, ToldDoubts& told, std::vector<std::string>& messages) const;
  /// The linear law alone: of bodies that something else holds within the grid.
  void look_at_turns(std::span<const double> q, double time, ToldDoubts& told,
                     std::vector<std::string>& messages) const;
  /// Whether steps follow the motion: v0 and v1 are the velocities at a step's ends, the masses those of the nodes.
  static void look_at_swings(std::span<const double> v0, std::span<const double> v1, std::span<const double> masses,
                             double time, ToldDoubts& told, std::vector<std::string>& messages);

 private:
  void look_at_edges(std::span<const double> q, double time, ToldDoubts& told,
                     std::vector<std::string>& messages) const;
  double left_out(std::size_t e, std::span<const double> q) const;
  std::string region_of_node(std::size_t node) const;

  const Solids& solids_;
  const BackgroundGrid& grid_;
  std::vector<std::size_t> linear_;  // elements of linear laws
  std::vector<bool> free_;           // of each node, whether nothing holds its body
};

}  // namespace tether::fem
