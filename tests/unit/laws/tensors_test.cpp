// SPDX-License-Identifier: GPL-3.0-or-later
#include "laws/tensors.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tether {
namespace {

TEST(Tensors, SymmetricPartHasNoSpin) {  // (4.2)
  const StrainRate d = symmetric_part({1, 6, -2, 3});
  EXPECT_EQ(d.xx, 1);
  EXPECT_EQ(d.yy, 3);
  EXPECT_EQ(d.xy, 2);
  EXPECT_EQ(symmetric_part({0, -5, 5, 0}).xy, 0);
}

/// sigma : grad v of a symmetric stress needs the symmetric part only: 2 (1) + 3 (3) + 4 (6 - 2) = 27.
TEST(Tensors, PowerCountsTheShearTwice) {
  const VelocityGradient L{1, 6, -2, 3};
  const Stress s{2, 3, 4};
  EXPECT_EQ(power(s, symmetric_part(L)), 27);
  EXPECT_EQ(power(s, symmetric_part(L)), s.xx * L.xx + s.xy * (L.xy + L.yx) + s.yy * L.yy);
}

TEST(Tensors, StretchAlongALine) {  // (5.2)
  const StrainRate d{1, 3, 2};
  EXPECT_EQ(along(d, {1, 0}), 1);
  EXPECT_EQ(along(d, {0, 1}), 3);
  EXPECT_NEAR(along(d, {std::sqrt(0.5), std::sqrt(0.5)}), 4, 1e-15);   // mean of 1 and 3, and the shear
  EXPECT_NEAR(along(d, {std::sqrt(0.5), -std::sqrt(0.5)}), 0, 1e-15);  // and less the shear
  EXPECT_NEAR(along(d, {0.6, 0.8}), 0.36 + 3 * 0.64 + 4 * 0.48, 1e-15);
}

}  // namespace
}  // namespace tether
