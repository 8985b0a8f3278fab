// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/rows.hpp"

#include <gtest/gtest.h>

namespace tether {
namespace {

struct Two {
  std::vector<double> a;
  std::vector<int> b;
};
constexpr ArrayField a{"a", &Two::a, Dimension::length, "a length"};
constexpr ArrayField b{"b", &Two::b, Dimension::number, "a number", Kept::within_step};

static_assert(lists_each_array_once<Two>(std::tuple{a, b}));
static_assert(!lists_each_array_once<Two>(std::tuple{a}), "one is missing");
static_assert(!lists_each_array_once<Two>(std::tuple{a, a}), "one stands there twice in the place of the other");
static_assert(!lists_each_array_once<Two>(std::tuple{a, ArrayField{"a", &Two::b, Dimension::number, "a number"}}),
              "two have one name");

TEST(ArrayFields, TakeWhatTheirNumbersTake) {
  EXPECT_EQ(bytes_of_arrays<Two>(std::tuple{a, b}).always, sizeof(double));
  EXPECT_EQ(bytes_of_arrays<Two>(std::tuple{a, b}).asked, sizeof(int));
  EXPECT_EQ(bytes_of_saved_arrays(std::tuple{a, b}), sizeof(double));  // the other is not remembered
}

TEST(ArrayFields, AreVisitedInTheirOrder) {
  std::string names;
  each_row(std::tuple{a, b}, [&](const auto& row) { names += row.name; });
  EXPECT_EQ(names, "ab");
}

}  // namespace
}  // namespace tether
