// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "physics/points/normals_cells.hpp"

namespace tether::mpm {

/// A symmetric positive definite matrix, of which each row is kept from its first entry to the diagonal: what the
/// Cholesky factor fills. Unknowns that are numbered along a curve have short rows. Memory is kept between uses.
class ProfileMatrix {
 public:
  void reserve(std::size_t rows, std::size_t entries) {
    first_.reserve(rows);
    start_.reserve(rows);
    entries_.reserve(entries);
  }
  /// A matrix of zeros; `first` is each row's first column.
  void shape(std::span<const std::size_t> first) {
    first_.assign(first.begin(), first.end());
    start_.resize(first.size());
    std::size_t entries = 0;
    for (std::size_t i = 0; i < first.size(); ++i) start_[i] = entries, entries += i + 1 - first[i];
    entries_.assign(entries, 0.0);
  }
  std::size_t rows() const { return first_.size(); }
  double& at(std::size_t i, std::size_t j) { return entries_[start_[i] + j - first_[i]]; }
  double at(std::size_t i, std::size_t j) const { return entries_[start_[i] + j - first_[i]]; }

  /// Puts the Cholesky factor in the matrix' place.
  void factor() {
    for (std::size_t i = 0; i < rows(); ++i) {
      for (std::size_t j = first_[i]; j < i; ++j) at(i, j) = (at(i, j) - product(i, j)) / at(j, j);
      at(i, i) = std::sqrt(at(i, i) - product(i, i));
    }
  }
  /// After factor(): from the right-hand side to the solution.
  void solve(std::span<double> x) const {
    for (std::size_t i = 0; i < rows(); ++i) {
      for (std::size_t j = first_[i]; j < i; ++j) x[i] -= at(i, j) * x[j];
      x[i] /= at(i, i);
    }
    for (std::size_t i = rows(); i-- > 0;) {
      x[i] /= at(i, i);
      for (std::size_t j = first_[i]; j < i; ++j) x[j] -= at(i, j) * x[i];
    }
  }

 private:
  /// Multiplies rows i and j over the columns before j that both have.
  double product(std::size_t i, std::size_t j) const {
    double sum = 0;
    for (std::size_t k = std::max(first_[i], first_[j]); k < j; ++k) sum += at(i, k) * at(j, k);
    return sum;
  }

  std::vector<std::size_t> first_, start_;
  std::vector<double> entries_;
};

/// The mass matrix method with one matrix for the whole membrane (7.12). Cells share colours, so the extra points, one
/// a cell, must agree: each has as its colour its height above the line nearest to its cell's points, counted to the
/// left of the tangents of before: the colour comes out as a distance from the membrane. A point that is alone in its
/// cell takes the direction of its extra point from the ghost cell (Fig. 88).
template <class Color>
class MembraneMatrixNormals {
 public:
  MembraneMatrixNormals(const BackgroundGrid& shape, const Walls& walls, std::size_t most_points);
  void update(const PlaceArrays& places, Range membrane, const Tangents& tangents);

 private:
  using Cell = MembraneCells::Cell;
  using Row = typename Color::Row;
  using Block = std::array<Row, Color::count>;
  using Unknowns = std::array<std::size_t, Color::count>;

  Unknowns keys_of(const Cell& cell) const;
  void number_unknowns();
  void visit_around(std::size_t seed);
  void number(std::size_t cell);
  void set_profile();
  void solve(const Tangents& tangents);
  void assemble(std::size_t cell, const Tangents& tangents);
  NearestLine line_of(const Cell& cell);
  void add_extra(const Cell& cell, const Tangents& tangents, Block& block, Row& right);
  bool stiffen_what_turns_round();
  void gradients_of(std::size_t cell);

  BackgroundGrid shape_;
  MembraneCells cells_;
  Block stiffness_{};
  std::vector<std::size_t> keys_, numbers_, order_, first_;  // of the colours' places, and their numbers as unknowns
  std::vector<unsigned char> reached_;                       // cells that stand in order_
  std::vector<Unknowns> unknowns_;                           // by cell
  std::vector<double> factors_;                              // of its stiffness
  std::size_t numbered_ = 0;
  ProfileMatrix matrix_;
  std::vector<double> colors_;
  std::vector<LocalPlace> cell_places_, ghost_places_;
  std::vector<Pair> gradients_;  // of a cell's points
};

}  // namespace tether::mpm
