// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tether {
namespace {

template <class Test>
void for_all_shapes(const Test& test) {
  for (const ElementRow& row : element_rows) {
    SCOPED_TRACE(std::string(row.name) + " in " + std::to_string(row.dim) + " dimensions");
    with_shapes(row.kind, [&](auto shapes) { test(row, shapes); });
  }
}

/// A place within any reference element.
template <int dim>
Vec<dim> some_place() {
  Vec<dim> s;
  for (int i = 0; i < dim; ++i) s[at(i)] = 0.13 + 0.11 * i;
  return s;
}

TEST(Shapes, SumToOneAndHaveTheirGradients) {
  for_all_shapes([](const ElementRow&, auto shapes) {
    using S = decltype(shapes);
    const Vec<S::dim> s = some_place<S::dim>();
    const auto N = S::values(s);
    const auto G = S::gradients(s);
    double sum = 0;
    for (const double value : N) sum += value;
    EXPECT_NEAR(sum, 1, 1e-14);
    constexpr double h = 1e-6;
    for (int i = 0; i < S::dim; ++i) {
      Vec<S::dim> up = s, down = s;
      up[at(i)] += h, down[at(i)] -= h;
      for (int a = 0; a < S::nodes; ++a)
        EXPECT_NEAR(G[at(a * S::dim + i)], (S::values(up)[at(a)] - S::values(down)[at(a)]) / (2 * h), 1e-9);
    }
  });
}

TEST(Shapes, AreOneAtTheirOwnNodeAlone) {
  for_all_shapes([](const ElementRow&, auto shapes) {
    using S = decltype(shapes);
    for (int a = 0; a < S::nodes; ++a) {
      const auto N = S::values(S::node_place(a));
      for (int b = 0; b < S::nodes; ++b) EXPECT_NEAR(N[at(b)], a == b ? 1 : 0, 1e-15);
    }
  });
}

/// Integral of s_0^i s_1^j s_2^k over the reference element.
template <class S>
double exact(const std::array<int, 3>& powers) {
  double value = 1;
  if constexpr (S::is_simplex) {
    int sum = S::dim;
    for (int i = 0; i < S::dim; ++i) value *= std::tgamma(powers[at(i)] + 1), sum += powers[at(i)];
    return value / std::tgamma(sum + 1);
  } else {
    for (int i = 0; i < S::dim; ++i) value *= powers[at(i)] % 2 == 1 ? 0 : 2.0 / (powers[at(i)] + 1);
    return value;
  }
}

template <class S, class Place, class Weight>
double by_rule(int points, const std::array<int, 3>& powers, const Place& place, const Weight& weight) {
  double sum = 0;
  for (int k = 0; k < points; ++k) {
    double value = weight(k);
    for (int i = 0; i < S::dim; ++i) value *= std::pow(place(k)[at(i)], powers[at(i)]);
    sum += value;
  }
  return sum;
}

/// Rules are exact to their orders, and those of masses have positive weights.
TEST(Shapes, RulesAreExact) {
  for_all_shapes([](const ElementRow& row, auto shapes) {
    using S = decltype(shapes);
    for (int k = 0; k < S::mass_points; ++k) EXPECT_GT(S::mass_weight(k), 0);
    for (int i = 0; i <= 2 * row.order; ++i) {
      for (int j = 0; i + j <= 2 * row.order; ++j) {
        for (int k = 0; i + j + k <= (row.dim == 3 ? 2 * row.order : i + j); ++k) {
          const std::array powers{i, j, k};
          const double right = exact<S>(powers);
          EXPECT_NEAR(by_rule<S>(S::mass_points, powers, S::mass_place, S::mass_weight), right, 1e-14);
          if (i + j + k > 2) continue;
          EXPECT_NEAR(by_rule<S>(S::points, powers, S::place, S::weight), right, 1e-14);
        }
      }
    }
  });
}

}  // namespace
}  // namespace tether
