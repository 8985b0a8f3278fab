// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <functional>

#include "read/points/curves.hpp"

namespace tether::test {

inline void expect_near(const Vec<2>& here, const Vec<2>& there, double error) {
  EXPECT_NEAR(here[0], there[0], error);
  EXPECT_NEAR(here[1], there[1], error);
}

/// Integral by Simpson's rule on 20000 panels: another way to a length than the code's own.
inline double integral(const std::function<double(double)>& f, double a, double b) {
  constexpr int panels = 20000;
  const double h = (b - a) / panels;
  double sum = 0;
  for (int k = 0; k < panels; ++k) sum += f(a + k * h) + 4 * f(a + (k + 0.5) * h) + f(a + (k + 1) * h);
  return sum * h / 6;
}

}  // namespace tether::test
