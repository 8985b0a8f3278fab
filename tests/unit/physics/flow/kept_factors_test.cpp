// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/kept_factors.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tether::fem {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

KeptFactors made() {
  KeptFactors factors;
  factors.begin_step(true);
  EXPECT_TRUE(factors.are_due());
  factors.made(true, true);
  EXPECT_FALSE(factors.are_due());
  return factors;
}

TEST(KeptFactors, ThatLeadOnFastAreKeptFromStepToStep) {
  KeptFactors factors = made();
  for (int step = 0; step < 3; ++step) {
    EXPECT_TRUE(factors.lead_on(1e-2, 1e3));
    EXPECT_FALSE(factors.are_due());
    factors.begin_step(false);
    EXPECT_FALSE(factors.are_due());
  }
}

/// 1000 tolerances are left: by a tenth at a time it takes 3 corrections, by a half 10.
TEST(KeptFactors, ThatLeadOnSlowlyAreMadeAnew) {
  KeptFactors factors = made();
  EXPECT_TRUE(factors.lead_on(0.1, 1e3));
  EXPECT_FALSE(factors.are_due());
  EXPECT_TRUE(factors.lead_on(0.5, 1e3));
  EXPECT_TRUE(factors.are_due());
  factors.begin_step(false);
  EXPECT_FALSE(factors.are_due());  // the next step tries them
}

TEST(KeptFactors, OnlyNewOnesMayMakeTheResidualGrow) {
  for (const double ratio : {1.0, 2.0, nan}) {
    KeptFactors factors = made();
    EXPECT_TRUE(factors.lead_on(ratio, 10));
    EXPECT_TRUE(factors.are_due());
    factors = made();
    EXPECT_TRUE(factors.lead_on(1e-3, 10));
    EXPECT_FALSE(factors.lead_on(ratio, 10));
    EXPECT_TRUE(factors.are_due());
  }
}

TEST(KeptFactors, OfAnotherMatrixOrOfNoneAreNotKept) {
  KeptFactors factors = made();
  factors.begin_step(true);
  EXPECT_TRUE(factors.are_due());
  factors = made();
  factors.drop();
  EXPECT_TRUE(factors.are_due());
  factors.made(true, false);  // what GMRES works with
  EXPECT_TRUE(factors.are_due());
  factors.made(false, true);
  EXPECT_TRUE(factors.are_due());
}

}  // namespace
}  // namespace tether::fem
