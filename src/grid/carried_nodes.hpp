// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>
#include "algebra/eigen_sparse.hpp"

#include "grid/mesh_place.hpp"
#include "grid/node_lattice.hpp"

namespace tether {

/// Distance of carried nodes over that of the fluid's from which it is reported. Of a flap of one biquadratic element
/// across the tip's way, over that at 1.0, is 0.99 at 1.5, 0.77 at 1.74, 0.63 at 1.78, 0.30 at 2.05.
constexpr double coarse_spacing = 1.7;

/// Which nodes of immersed bodies the fluid carries, and how the others follow these: V = E V_c.
///
/// A body whose nodes stand closer than the fluid's asks more of the velocity than the fluid's functions have there: at
/// rest it is zero at all of them, so that it vanishes in every cell that the body cuts, however thin the sliver, and
/// the body grows by up to a cell. So of a body's lines of nodes only so many are carried as the fluid has nodes along
/// the way, in coarse biquadratic elements of about a cell of the fluid; the nodes in between follow by the functions
/// of these, and their forces go back by the transpose. Thin bodies
/// keep elements of four times their thickness: longer biquadratic ones lock as they bend far. Displacements of bodies
/// are sums of such, so that a body moves as one of coarse elements does, with the shape, the law and the quadrature of
/// its own. Bodies whose elements are as long as the fluid's or longer, and those whose elements are not in rows, are
/// carried at all of their nodes.
class CarriedNodes {
 public:
  /// All nodes of the regions that `whole` marks are carried (none: of no region). The meshes must outlive it.
  CarriedNodes(const Mesh& fluid, const Mesh& bodies, const std::vector<bool>& whole = {});

  /// Chooses for bodies whose nodes stand at x.
  void choose(std::span<const double> x);

  /// The nodes that are carried, ascending.
  const std::vector<int>& nodes() const { return nodes_; }
  bool all() const { return nodes_.size() == bodies_.node_count(); }
  /// E: rows for two numbers of each node, columns for two of each carried one.
  const EigenSparse& following() const { return following_; }
  /// V = E V_c, and F_c = E^T F.
  void follow(std::span<const double> carried, std::span<double> V) const;
  void gather(std::span<const double> F, std::span<double> carried) const;
  /// The largest distance of carried nodes over that of the fluid's nodes along it, for the places last chosen for.
  double coarsest() const { return coarsest_; }

 private:
  using Row = std::vector<std::pair<int, double>>;  // carried nodes and their parts
  /// Of a chain of lattices, over how many of the fluid's nodes each interval between lines is long, the sum and the
  /// largest over so many elements across it; how many elements it is to have, and the lines taken.
  struct Chain {
    std::vector<double> sum, most, count;
    double least_elements = 1;
    std::vector<std::size_t> lines;
  };

  void measure(std::span<const double> x);
  void measure_element(std::size_t e, const std::array<NodeSpacing, 4>& spacing);
  void rebuild();
  std::vector<double> places_of_way(std::size_t lattice, std::size_t way) const;
  std::vector<Row> rows_of_way(std::size_t lattice, std::size_t way) const;
  void add_rows(std::size_t lattice, std::vector<Row>& rows) const;
  void keep_linear_fields(int node, Row& row) const;
  void fill(const std::vector<Row>& rows);

  const Mesh& bodies_;
  NodeSpacings spacings_;
  std::vector<NodeLattice> lattices_;
  LatticeChains chains_of_;
  std::vector<int> lattice_of_;  // of each element its lattice, -1 where it stands in none
  std::vector<int> below_;       // and the fluid's element below it when last looked for
  std::vector<Chain> chains_;
  std::vector<int> nodes_;
  EigenSparse following_;
  double coarsest_ = 0, coarsest_loose_ = 0;  // of all, and of elements in no lattice
};

}  // namespace tether
