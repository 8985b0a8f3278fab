// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "base/warned.hpp"
#include "grid/boxes.hpp"
#include "grid/overlaps.hpp"
#include "model/solids.hpp"

namespace tether::fem {

/// A residual over the largest force above which a shape is no equilibrium to rely on.
inline constexpr double most_unbalanced = 1e-4;

/// What a run warns of about bodies on a mesh, each once.
enum class BodyDoubt { left_grid, turned, swings, unbalanced };

/// What it has warned of, and the numbers that doubts are known by.
struct BodyDoubtNumbers {
  long long warned = 0;
  long long looks = 0, reversals = 0;  ///< steps that moved, and those of them that turned the motion back
  double fastest = 0;                  ///< largest kinetic energy so far, as turned_back() takes it
  double spacing = 0;   ///< largest distance of nodes that a fluid carries so far, over that of the fluid's
  double thinnest = 0;  ///< cells of the fluid across the thinnest body, the least so far
};

/// As part of what a run saves.
template <class Exchange>
void exchange(Exchange& with, BodyDoubtNumbers& doubts) {
  with("doubts_warned", doubts.warned);
  with("doubt_looks", doubts.looks), with("doubt_reversals", doubts.reversals), with("doubt_fastest", doubts.fastest);
  with("doubt_spacing", doubts.spacing), with("doubt_thinnest", doubts.thinnest);
}

/// Nodes inside another body.
struct OverlapCount {
  long long now = 0;
  long long most = 0;  ///< at one time since the start
};

/// As part of what a run saves.
template <class Exchange>
void exchange(Exchange& with, OverlapCount& count) {
  with("nodes_inside", count.now), with("nodes_inside_most", count.most);
}

/// Looks whether bodies go on where the model does not hold any more: beyond the grid, where nothing stops them, or
/// turned further than a linear law follows. Each is reported once. The solids and the grid must outlive it.
class BodyDoubts {
 public:
  BodyDoubts(const Solids& solids, const BackgroundGrid& grid);

  void look(std::span<const double> q, double time, BodyDoubtNumbers& doubts, std::vector<std::string>& messages) const;
  /// The linear law alone: of bodies that something else holds within the grid.
  void look_at_turns(std::span<const double> q, double time, BodyDoubtNumbers& doubts,
                     std::vector<std::string>& messages) const;
  /// Looks whether an equilibrium is one: how much of the largest force is left over, at places q of nodes that stand
  /// at x at the start. A body that has not moved has none.
  static void look_at_balance(double residual, std::span<const double> q, std::span<const double> x, double time,
                              BodyDoubtNumbers& doubts, std::vector<std::string>& messages);
  /// Looks whether steps follow the motion: v0 and v1 are the velocities at a step's ends, the masses those of the
  /// nodes; where no more energy than `least` moves, nothing does.
  static void look_at_swings(std::span<const double> v0, std::span<const double> v1, std::span<const double> masses,
                             double least, double time, BodyDoubtNumbers& doubts, std::vector<std::string>& messages);

 private:
  void look_at_edges(std::span<const double> q, double time, BodyDoubtNumbers& doubts,
                     std::vector<std::string>& messages) const;
  double left_out(std::size_t e, std::span<const double> q) const;
  std::string region_of_node(std::size_t node) const;

  const Solids& solids_;
  const BackgroundGrid& grid_;
  std::vector<std::size_t> linear_;  // elements of linear laws
  std::vector<bool> free_;           // of each node, whether nothing holds its body
};

/// Nothing stops one body at another: it is seen here, counted and reported once. The solids must outlive it.
class BodyOverlaps {
 public:
  explicit BodyOverlaps(const Solids& solids) : solids_(solids), finder_(solids.mesh) {}

  /// Counts with the nodes at q; the first time that there are any a warning is added.
  void look(std::span<const double> q, double time, OverlapCount& count, std::vector<std::string>& messages);

 private:
  std::string name_of(int part) const;

  const Solids& solids_;
  OverlapFinder finder_;
};

}  // namespace tether::fem
