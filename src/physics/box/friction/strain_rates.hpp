// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/team.hpp"
#include "physics/box/friction/slopes.hpp"
#include "physics/box/friction/unknowns.hpp"

namespace tether::coupled {

/// What is beyond open sides of the box.
enum class Beyond {
  nothing,  ///< the fluid ends there, free of stress
  fluid     ///< it goes on as it comes: no velocity changes on the way out
};

/// How much of each half of a cell along each axis is liquid, as parts of it: number 2^dim cell + (1 where it is the
/// upper half along x) + (2 along y) + (4 along z). Empty where all is.
using CellParts = std::vector<double>;
/// Returns the mean over those parts of a cell that are its upper (1) or lower (0) half along the axes given; -1: both.
double mean_part(const CellParts& parts, int dim, std::size_t cell, const std::array<int, 3>& half);

/// Returns the mean over the halves of cells that a face's box has.
double part_of_face(const CellParts& parts, const StaggeredGrid& grid, int axis, const std::array<int, 3>& face);

/// The rates of strain of a fluid by the velocities of faces and of the nodes that it sticks to, and how much fluid has
/// each: (8) and (9) of C. Batty, R. Bridson, Proc. SCA (2008) 219-228. Their squares times mu are the power that
/// friction takes; its derivative is the force. In the middle of each cell are the rates along the axes, at each edge
/// those across. Most are differences of four faces at most, and stand on the lattice of the places; those next to
/// walls and solids stand in a list.
class StrainRates {
 public:
  /// The arguments need not outlive it but for the unknowns. `mu` is that of all, times a time [stress time^2].
  StrainRates(const FlowDomain& domain, const FrictionUnknowns& unknowns, const Slopes& slopes, const CellParts& parts,
              Beyond beyond, double mu);

  /// Finds the blocks of places that have rates and forces, once all squares are there.
  void find_blocks();
  /// y = K x, x and y of all unknowns, where K has any numbers: y must be 0 elsewhere.
  void find_forces(Team& team, std::span<const double> x, std::span<double> y);
  /// y += the diagonal of K.
  void add_diagonal(std::span<double> y) const;
  /// Calls f(unknowns, factors, weight) for each square that stands in the list, but for the differences of two squares
  /// that open sides have: weight (sum of factor times unknown)^2 is twice what it takes.
  template <class Function>
  void each_square(const Function& f) const {
    for (std::size_t s = 0; s + 1 < first_.size(); ++s) {
      const std::size_t count = first_[s + 1] - first_[s];
      if (of_two_[s] == 0)
        f(std::span(unknown_).subspan(first_[s], count), std::span(factor_).subspan(first_[s], count),
          square_weight_[s]);
    }
  }
  /// Adds a mass that faces attached to a solid give its nodes, by the combination that is the face's velocity less
  /// that of the solid [mass].
  void add_square(const Combination& rate, double weight, bool of_two = false);

 private:
  void add_cells(int a);
  void add_edges(int a, int b);
  void add_edge(int a, int b, const std::array<int, 3>& corner);
  void add_open_side(int a, const std::array<int, 3>& face_b, int b, const Slope& along_b, bool upper_side, double mu);
  void add_product(const Combination& of, std::size_t v, double weight);
  void add_open_corner(std::size_t u, std::size_t v, int a, int b, double mu);
  void add_quarter(int a, int b, const std::array<int, 3>& corner, bool upper_a, bool upper_b);
  bool is_whole_edge(int a, int b, const std::array<int, 3>& corner) const;
  bool is_fluid(const std::array<int, 3>& cell) const;
  double liquid_of(const std::array<int, 3>& cell, const std::array<int, 3>& half) const;
  void find_stresses(std::size_t a, std::size_t b, std::span<const double> x, std::size_t begin, std::size_t end);
  void add_stresses(std::size_t a, std::size_t begin, std::size_t end, std::span<double> y) const;

  const FrictionUnknowns& unknowns_;
  const FlowDomain* domain_;  // these are known while it is made
  const Slopes* slopes_;
  const CellParts* parts_;
  Beyond beyond_;
  double mu_;
  std::array<std::array<std::vector<double>, 3>, 3> weight_, stress_;  // of each place, for axes a <= b
  std::vector<std::size_t> with_rates_, with_forces_;                  // blocks of places
  std::vector<std::size_t> first_{0};                                  // of each square in the list
  std::vector<std::size_t> unknown_;
  std::vector<double> factor_, square_weight_;
  std::vector<std::uint8_t> of_two_;  // 1 where it is one of a difference
};

}  // namespace tether::coupled
