// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <vector>

#include "algebra/sparse_matrix.hpp"

namespace tether {

/// A square matrix by its entries, in any order; those of one place are summed.
class Entries {
 public:
  explicit Entries(std::int64_t n) : n_(n), columns_(static_cast<std::size_t>(n)) {}

  void add(std::int64_t i, std::int64_t j, double value) { columns_[static_cast<std::size_t>(j)][i] += value; }
  void add_both(std::int64_t i, std::int64_t j, double value) { add(i, j, value), add(j, i, value); }
  /// weight (x_i - x_j)^2
  void add_bond(std::int64_t i, std::int64_t j, double weight) {
    add(i, i, weight), add(j, j, weight), add_both(i, j, -weight);
  }
  SparseMatrix matrix() const {
    SparseMatrix A{n_, {0}, {}, {}};
    for (const auto& column : columns_) {
      for (const auto& [i, value] : column) A.row.push_back(i), A.value.push_back(value);
      A.start.push_back(static_cast<std::int64_t>(A.row.size()));
    }
    return A;
  }

 private:
  std::int64_t n_;
  std::vector<std::map<std::int64_t, double>> columns_;
};

/// A box of cells^dim cells with a round body in its middle, `shift` of an edge off it to the right.
struct BodyInBox {
  int dim = 2, cells = 16;
  double shift = 0;
  bool open = true;    ///< the right side, where the pressure is 0
  double ratio = 100;  ///< how much the weights of faces vary
};

/// The pressures of that box, and the velocities of points on the body's surface, stiffly held together.
class BodyMatrices {
 public:
  explicit BodyMatrices(const BodyInBox& box) : box_(box) {
    for (int d = 0; d < box.dim; ++d) cell_count_ *= box.cells;
    for (int c = 0; c < cell_count_; ++c) fluid_.push_back(distance(middle(c)) > radius ? 1 : 0);
    make_points();
  }

  std::int64_t cells() const { return cell_count_; }
  std::int64_t velocities() const { return box_.dim * static_cast<std::int64_t>(points_.size()); }

  /// Differences of fluxes: 5 or 7 points, a body's cell by itself with 1. `added`: of the body's points of that
  /// inverse mass, which couple all cells about a point.
  SparseMatrix pressures(double added = 0) const {
    Entries L(cell_count_);
    add_pressures(L, 0, 1);
    for (std::size_t s = 0; added > 0 && s < points_.size(); ++s) {
      for (const auto& [c, b] : about(s)) {
        for (const auto& [e, d] : about(s)) L.add(c, e, added * b * d);
      }
    }
    return L.matrix();
  }

  /// [A, -B^T; -B, -L], velocities first.
  SparseMatrix coupled(double mass, double stiffness) const {
    Entries K(velocities() + cell_count_);
    add_pressures(K, velocities(), -1);
    const auto count = static_cast<std::int64_t>(points_.size());
    for (std::int64_t s = 0; s < count; ++s) {
      for (std::int64_t d = 0; d < box_.dim; ++d) {
        K.add(box_.dim * s + d, box_.dim * s + d, mass);
        for (const std::int64_t other : {s + 1, s + 8}) {
          if (other < count) K.add_bond(box_.dim * s + d, box_.dim * other + d, stiffness);
        }
        for (const auto& [c, b] : about(static_cast<std::size_t>(s)))
          K.add_both(velocities() + c, box_.dim * s + d, -b * normal(static_cast<std::size_t>(s), d));
      }
    }
    return K.matrix();
  }

 private:
  using Point = std::array<double, 3>;
  static constexpr double radius = 0.2;

  Point middle(int c) const {
    Point x{0.5, 0.5, 0.5};
    for (int d = 0; d < box_.dim; ++d, c /= box_.cells)
      x[static_cast<std::size_t>(d)] = (c % box_.cells + 0.5) / box_.cells;
    return x;
  }
  double distance(const Point& x) const { return std::hypot(x[0] - 0.5 - box_.shift, x[1] - 0.5, x[2] - 0.5); }
  double normal(std::size_t s, std::int64_t d) const {
    const double at = 0.5 + (d == 0 ? box_.shift : 0);
    return (points_[s][static_cast<std::size_t>(d)] - at) / radius;
  }

  /// About two a cell's width, in a spiral from pole to pole.
  void make_points() {
    const double per_radius = radius * box_.cells, turn = std::numbers::pi * (3 - std::sqrt(5.0));
    const auto count = static_cast<int>(box_.dim == 2 ? 12 * per_radius : 24 * per_radius * per_radius);
    for (int s = 0; s < count; ++s) {
      const double z = box_.dim == 2 ? 0 : (2 * s + 1.0) / count - 1, r = std::sqrt(1 - z * z);
      const double angle = box_.dim == 2 ? 2 * std::numbers::pi * s / count : turn * s;
      points_.push_back(
          {0.5 + box_.shift + radius * r * std::cos(angle), 0.5 + radius * r * std::sin(angle), 0.5 + radius * z});
    }
  }

  /// The fluid cells whose middles are about point s, with weights.
  std::vector<std::pair<std::int64_t, double>> about(std::size_t s) const {
    std::vector<std::pair<std::int64_t, double>> cells;
    for (int corner = 0; corner < (1 << box_.dim); ++corner) {
      std::int64_t c = 0, stride = 1;
      double weight = 1;
      for (int d = 0; d < box_.dim; ++d, stride *= box_.cells) {
        const double at = points_[s][static_cast<std::size_t>(d)] * box_.cells - 0.5, low = std::floor(at);
        const int up = corner >> d & 1;
        c += stride * static_cast<std::int64_t>(low + up), weight *= up ? at - low : 1 - (at - low);
      }
      if (fluid_[static_cast<std::size_t>(c)]) cells.emplace_back(c, weight);
    }
    return cells;
  }

  void add_pressures(Entries& to, std::int64_t first, double sign) const {
    for (int c = 0; c < cell_count_; ++c) {
      if (!fluid_[static_cast<std::size_t>(c)]) to.add(first + c, first + c, sign);
      for (int d = 0, stride = 1; d < box_.dim; ++d, stride *= box_.cells) {
        const int place = c / stride % box_.cells;
        const double weight = sign * std::pow(box_.ratio, 0.5 * std::sin(12.9898 * c + 78.233 * d));
        if (!fluid_[static_cast<std::size_t>(c)]) continue;
        if (place + 1 < box_.cells) {
          if (fluid_[static_cast<std::size_t>(c + stride)]) to.add_bond(first + c, first + c + stride, weight);
        } else if (d == 0 && box_.open) {
          to.add(first + c, first + c, 2 * weight);
        }
      }
    }
  }

  BodyInBox box_;
  int cell_count_ = 1;
  std::vector<std::uint8_t> fluid_;
  std::vector<Point> points_;
};

}  // namespace tether
