// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <span>
#include <utility>
#include <vector>

#include "physics/box/pressure_sampler.hpp"

namespace tether::coupled {

/// What solids and fluid are to a film: all of it must outlive the films.
struct FilmsOf {
  const SolidSurface& surface;
  std::span<const double> q;
  const SurfacePieces& pieces;
  const FlowDomain& domain;
  const PressureSampler& sampler;
  std::span<const int> before;     ///< of each piece the cell before it, as the sampler finds it
  std::span<const int> open_side;  ///< of each piece the open side straight before it, or -1
};

/// Films of fluid that no cell resolves: between a solid and a wall, or another solid, nearer than half a cell.
///
/// The surface's pieces there have no cell before them. Fluid that is thin and slow against what is around it has a
/// harmonic pressure along the surface, between those at its rims, where pieces have cells before them: in the plane
/// linear from rim to rim. The surface leads there and never through a solid. Surfaces that touch have a film, too.
class FilmPressures {
 public:
  FilmPressures(Team& team, const FilmsOf& of);

  /// The pressure on a piece without a cell before it, as a sum over cells. Empty where a film has no rims, or rims of
  /// two regions of the fluid, which the solid shuts off from each other; beyond the box; within another solid.
  std::vector<std::pair<std::size_t, double>> on(std::size_t piece) const;
  /// The share that pieces beyond open sides, or straight before them, have in that pressure, by pressure(piece)
  /// [stress].
  template <class Pressure>
  double outside_on(std::size_t piece, const Pressure& pressure) const {
    double sum = 0;
    if (number_.empty() || number_[piece] < 0) return sum;
    for_shares(number_[piece], [&](std::size_t rim, double part) {
      if (kind_[rim] == Kind::outlet) sum += part * pressure(rim);
    });
    return sum;
  }

 private:
  enum class Kind : std::uint8_t { rim, film, outlet, none };
  Kind kind_of(std::size_t piece) const;
  bool is_in_another_solid(const SurfacePiece& piece) const;
  bool lets_out(int axis, int end) const;
  void list_sides_of_nodes();
  std::vector<int> touching(std::size_t piece) const;
  void add_ends(int side, int node, std::vector<int>& found) const;
  void add_near(std::size_t piece, int side, std::vector<int>& found) const;
  void number_films();
  bool number_whole(int piece);
  void link_films();
  double conductance(std::size_t film, std::size_t other) const;
  void share_rims(Team& team);
  Eigen::SparseMatrix<double> laplacian() const;

  struct Link {
    int film = 0, other = 0;  // by piece
    double conductance = 0;
  };
  /// Calls f(rim, part) for the rims that have a part in the pressure of a film's piece.
  template <class Function>
  void for_shares(int number, const Function& f) const {
    for (Eigen::Index r = 0; r < shares_.rows(); ++r) {
      if (shares_(r, number) != 0) f(static_cast<std::size_t>(rims_[static_cast<std::size_t>(r)]), shares_(r, number));
    }
  }

  FilmsOf of_;
  std::vector<Kind> kind_;               // of each piece
  std::vector<int> first_;               // of each side its first piece; the pieces of a side follow each other
  std::vector<std::vector<int>> sides_;  // of each node
  std::vector<int> number_;              // of each piece that a rim is joined with, from 0; else -1
  std::vector<int> films_;               // the piece of each number
  std::vector<Link> links_;
  std::vector<int> rims_;   // pieces next to films, ascending
  Eigen::MatrixXd shares_;  // of each rim, by rows, in the pressure of each number
};

}  // namespace tether::coupled
