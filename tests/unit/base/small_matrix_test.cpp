// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/small_matrix.hpp"

#include <gtest/gtest.h>

namespace tether {
namespace {

template <class A, int rows, int columns>
void expect_equal(const MatrixEntries<A, rows, columns>& found, const SmallMatrix<rows, columns>& expected) {
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) EXPECT_EQ(found(i, j), expected(i, j)) << i << ' ' << j;
  }
}

const SmallMatrix<2, 3> A = {1, 2, 3,  //
                             4, 5, 6};

TEST(SmallMatrix, TakesEntriesByRowsAndHoldsThemByColumns) {
  EXPECT_EQ(A(0, 2), 3);
  EXPECT_EQ(A(1, 0), 4);
  EXPECT_EQ(A.data()[1], 4);
  expect_equal(SmallMatrix<3, 1>(Vec<3>{7, 8, 9}), {7, 8, 9});
}

TEST(SmallMatrix, AddsAndMultiplies) {
  const SmallMatrix<2, 3> B = {1, 0, -1,  //
                               2, 1, 0};
  expect_equal(A + B, {2, 2, 2, 6, 6, 6});
  expect_equal(A - B, {0, 2, 4, 2, 4, 6});
  expect_equal(-B, {-1, 0, 1, -2, -1, 0});
  expect_equal(2 * A / 4, {0.5, 1, 1.5, 2, 2.5, 3});
  expect_equal(A * B.transpose(), {-2, 4, -2, 13});
  expect_equal(B.transpose() * A, {9, 12, 15, 4, 5, 6, -1, -2, -3});
  expect_equal(A * SmallMatrix<3, 3>::Identity(), A);
}

TEST(SmallMatrix, WritesToItsParts) {
  SmallMatrix<3, 3> C = SmallMatrix<3, 3>::Zero();
  C.block<2, 3>(1, 0) = A;
  C.col(1) -= SmallMatrix<3, 1>{1, 1, 1};
  C.row(0) = C.col(2).transpose();
  C.block<1, 1>(2, 2) *= 10;
  expect_equal(C, {0, 3, 6,  //
                   1, 1, 3,  //
                   4, 4, 60});
  double numbers[] = {1, 2, 3};
  column_at<2>(numbers + 1) += SmallMatrix<2, 1>{10, 20};
  EXPECT_EQ(numbers[0] + numbers[1] + numbers[2], 1 + 12 + 23);
}

TEST(SmallMatrix, MeasuresVectors) {
  const SmallMatrix<3, 1> x = {2, 3, 6}, y = {1, 0, 1};
  EXPECT_EQ(x.norm(), 7);
  EXPECT_EQ(x.dot(y), 8);
  EXPECT_EQ(A.row(1).dot(A.row(0)), 32);
  EXPECT_EQ(A.squaredNorm(), 91);
  expect_equal(cross(x, y), {3, 4, -3});
}

}  // namespace
}  // namespace tether
