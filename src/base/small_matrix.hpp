// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>

#include "base/vec.hpp"

namespace tether {

// Matrices of a few numbers whose rows and columns are known to the compiler, with Eigen's words for what they can do.
// They are for kernels of many sizes, of which the compiler would spend its time on choosing among Eigen's
// expressions: here each operation is done at once, by a plain loop, and sums add their terms in order.

template <class Number, int rows, int columns, int down, int right>
class MatrixPart;
template <int rows, int columns>
class SmallMatrix;

/// What a matrix and a part of one, which is `Self`, can do. Self::data() is where the first entry stands, and so many
/// numbers farther, Self::below and Self::beside, stand the one below it and the one right of it.
template <class Self, int rows, int columns>
class MatrixEntries {
 public:
  auto& operator()(int i, int j) { return self().data()[i * Self::below + j * Self::beside]; }
  const double& operator()(int i, int j) const { return self().data()[i * Self::below + j * Self::beside]; }
  /// An entry of a single row or column.
  auto& operator[](int i) { return self().data()[i * step()]; }
  const double& operator[](int i) const { return self().data()[i * step()]; }

  template <int height, int width>
  auto block(int i, int j) {
    return part<height, width, Self::below, Self::beside>(&(*this)(i, j));
  }
  template <int height, int width>
  auto block(int i, int j) const {
    return part<height, width, Self::below, Self::beside>(&(*this)(i, j));
  }
  auto col(int j) { return block<rows, 1>(0, j); }
  auto col(int j) const { return block<rows, 1>(0, j); }
  auto row(int i) { return block<1, columns>(i, 0); }
  auto row(int i) const { return block<1, columns>(i, 0); }
  auto transpose() const { return part<columns, rows, Self::beside, Self::below>(self().data()); }

  template <class Other>
  Self& operator+=(const MatrixEntries<Other, rows, columns>& other) {
    for (int j = 0; j < columns; ++j) {
      for (int i = 0; i < rows; ++i) (*this)(i, j) += other(i, j);
    }
    return self();
  }
  template <class Other>
  Self& operator-=(const MatrixEntries<Other, rows, columns>& other) {
    for (int j = 0; j < columns; ++j) {
      for (int i = 0; i < rows; ++i) (*this)(i, j) -= other(i, j);
    }
    return self();
  }
  Self& operator*=(double factor) { return self() = factor * self(); }

  template <class Other>
  double dot(const MatrixEntries<Other, rows, columns>& other) const {
    double sum = (*this)[0] * other[0];
    for (int k = 1; k < rows * columns; ++k) sum += (*this)[k] * other[k];
    return sum;
  }
  double squaredNorm() const {
    double sum = 0;
    for (int j = 0; j < columns; ++j) {
      for (int i = 0; i < rows; ++i) sum += (*this)(i, j) * (*this)(i, j);
    }
    return sum;
  }
  double norm() const { return std::sqrt(squaredNorm()); }

 protected:
  template <class Other>
  Self& assign(const MatrixEntries<Other, rows, columns>& other) {
    for (int j = 0; j < columns; ++j) {
      for (int i = 0; i < rows; ++i) (*this)(i, j) = other(i, j);
    }
    return self();
  }

 private:
  static constexpr int step() {
    static_assert(rows == 1 || columns == 1);
    return columns == 1 ? Self::below : Self::beside;
  }
  template <int height, int width, int down, int right, class Number>
  static auto part(Number* first) {
    return MatrixPart<Number, height, width, down, right>(first);
  }
  Self& self() { return static_cast<Self&>(*this); }
  const Self& self() const { return static_cast<const Self&>(*this); }
};

/// A block of a matrix, or of its transpose: what is written to it is written to the matrix, which must outlive it.
template <class Number, int rows, int columns, int down, int right>
class MatrixPart : public MatrixEntries<MatrixPart<Number, rows, columns, down, right>, rows, columns> {
 public:
  static constexpr int below = down, beside = right;

  explicit MatrixPart(Number* first) : first_(first) {}
  MatrixPart(const MatrixPart&) = default;
  MatrixPart& operator=(const MatrixPart& other) { return this->assign(other); }
  template <class Other>
  MatrixPart& operator=(const MatrixEntries<Other, rows, columns>& other) {
    return this->assign(other);
  }
  Number* data() const { return first_; }

 private:
  Number* first_;
};

/// Its entries stand in memory column by column.
template <int rows, int columns>
class SmallMatrix : public MatrixEntries<SmallMatrix<rows, columns>, rows, columns> {
 public:
  static constexpr int below = 1, beside = rows;

  /// Entries have no values yet.
  SmallMatrix() = default;
  /// Entries are given row by row.
  template <std::convertible_to<double>... Number>
  requires(sizeof...(Number) == std::size_t{rows * columns}) SmallMatrix(Number... numbers) {
    int k = 0;
    for (const double number : {static_cast<double>(numbers)...}) {
      (*this)(k / columns, k % columns) = number;
      ++k;
    }
  }
  explicit SmallMatrix(const Vec<rows>& column) requires(columns == 1) : numbers_(column) {}
  template <class Other>
  SmallMatrix(const MatrixEntries<Other, rows, columns>& other) {
    this->assign(other);
  }

  static SmallMatrix Zero() {
    SmallMatrix zero;
    zero.numbers_.fill(0);
    return zero;
  }
  static SmallMatrix Identity() {
    SmallMatrix unit = Zero();
    for (int i = 0; i < rows; ++i) unit(i, i) = 1;
    return unit;
  }
  double* data() { return numbers_.data(); }
  const double* data() const { return numbers_.data(); }

 private:
  Vec<rows * columns> numbers_;
};

/// Returns the numbers that stand there as a column, which reads and writes them.
template <int rows, class Number>
auto column_at(Number* first) {
  return MatrixPart<Number, rows, 1, 1, rows>(first);
}

template <class A, class B, int rows, int columns>
SmallMatrix<rows, columns> operator+(const MatrixEntries<A, rows, columns>& a,
                                     const MatrixEntries<B, rows, columns>& b) {
  SmallMatrix<rows, columns> sum;
  for (int j = 0; j < columns; ++j) {
    for (int i = 0; i < rows; ++i) sum(i, j) = a(i, j) + b(i, j);
  }
  return sum;
}

template <class A, class B, int rows, int columns>
SmallMatrix<rows, columns> operator-(const MatrixEntries<A, rows, columns>& a,
                                     const MatrixEntries<B, rows, columns>& b) {
  SmallMatrix<rows, columns> difference;
  for (int j = 0; j < columns; ++j) {
    for (int i = 0; i < rows; ++i) difference(i, j) = a(i, j) - b(i, j);
  }
  return difference;
}

template <class A, int rows, int columns>
SmallMatrix<rows, columns> operator-(const MatrixEntries<A, rows, columns>& a) {
  SmallMatrix<rows, columns> negative;
  for (int j = 0; j < columns; ++j) {
    for (int i = 0; i < rows; ++i) negative(i, j) = -a(i, j);
  }
  return negative;
}

template <class A, int rows, int columns>
SmallMatrix<rows, columns> operator*(double factor, const MatrixEntries<A, rows, columns>& a) {
  SmallMatrix<rows, columns> multiple;
  for (int j = 0; j < columns; ++j) {
    for (int i = 0; i < rows; ++i) multiple(i, j) = factor * a(i, j);
  }
  return multiple;
}

template <class A, int rows, int columns>
SmallMatrix<rows, columns> operator*(const MatrixEntries<A, rows, columns>& a, double factor) {
  return factor * a;
}

template <class A, int rows, int columns>
SmallMatrix<rows, columns> operator/(const MatrixEntries<A, rows, columns>& a, double divisor) {
  SmallMatrix<rows, columns> quotient;
  for (int j = 0; j < columns; ++j) {
    for (int i = 0; i < rows; ++i) quotient(i, j) = a(i, j) / divisor;
  }
  return quotient;
}

template <class A, class B, int rows, int inner, int columns>
SmallMatrix<rows, columns> operator*(const MatrixEntries<A, rows, inner>& a,
                                     const MatrixEntries<B, inner, columns>& b) {
  SmallMatrix<rows, columns> product;
  for (int j = 0; j < columns; ++j) {
    for (int i = 0; i < rows; ++i) product(i, j) = a(i, 0) * b(0, j);
    for (int k = 1; k < inner; ++k) {
      for (int i = 0; i < rows; ++i) product(i, j) += a(i, k) * b(k, j);
    }
  }
  return product;
}

inline SmallMatrix<3, 1> cross(const SmallMatrix<3, 1>& a, const SmallMatrix<3, 1>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace tether
