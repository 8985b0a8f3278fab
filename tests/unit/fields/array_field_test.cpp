// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/rows.hpp"

#include <gtest/gtest.h>

namespace tether {
namespace {

struct Two {
  std::vector<double> lengths;
  std::vector<int> counts;
};
constexpr ArrayField lengths{"a", &Two::lengths, Dimension::length, "a length"};
constexpr ArrayField counts{"b", &Two::counts, Dimension::number, "a number", Kept::within_step};

static_assert(lists_each_array_once<Two>(std::tuple{lengths, counts}));
static_assert(!lists_each_array_once<Two>(std::tuple{lengths}), "one is missing");
static_assert(!lists_each_array_once<Two>(std::tuple{lengths, lengths}),
              "one stands there twice in the place of the other");
static_assert(!lists_each_array_once<Two>(std::tuple{lengths,
                                                     ArrayField{"a", &Two::counts, Dimension::number, "a number"}}),
              "two have one name");

TEST(ArrayFields, TakeWhatTheirNumbersTake) {
  EXPECT_EQ(bytes_of_arrays<Two>(std::tuple{lengths, counts}).always, sizeof(double));
  EXPECT_EQ(bytes_of_arrays<Two>(std::tuple{lengths, counts}).asked, sizeof(int));
  EXPECT_EQ(bytes_of_saved_arrays(std::tuple{lengths, counts}), sizeof(double));  // the other is not remembered
}

TEST(ArrayFields, AreVisitedInTheirOrder) {
  std::string names;
  each_row(std::tuple{lengths, counts}, [&](const auto& row) { names += row.name; });
  EXPECT_EQ(names, "ab");
}

}  // namespace
}  // namespace tether
