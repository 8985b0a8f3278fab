// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/rows.hpp"

#include <gtest/gtest.h>

namespace tether {
namespace {

struct Three {
  double a = 0;
  bool b = false;
  long long c = 0;
};
constexpr NumberField a{"a", &Three::a};
constexpr NumberField b{"b", &Three::b};
constexpr NumberField c{"c", &Three::c};

static_assert(count_members<Three>() == 3);
static_assert(lists_each_number_once<Three>(std::tuple{a, b, c}));
static_assert(!lists_each_number_once<Three>(std::tuple{a, b}), "one is missing");
static_assert(!lists_each_number_once<Three>(std::tuple{a, b, b}), "one stands there twice in the place of the other");
static_assert(!lists_each_number_once<Three>(std::tuple{a, b, NumberField{"b", &Three::c}}), "two have one name");

TEST(NumberFields, GiveTheirMembers) {
  Three three{1.5, true, 7};
  EXPECT_EQ(three.*a.number, 1.5);
  EXPECT_EQ(three.*c.number, 7);
}

}  // namespace
}  // namespace tether
