// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/rows.hpp"

#include <gtest/gtest.h>

namespace tether {
namespace {

struct Three {
  double real = 0;
  bool truth = false;
  long long c = 0;
};
constexpr NumberField real{"a", &Three::real};
constexpr NumberField truth{"b", &Three::truth};
constexpr NumberField c{"c", &Three::c};

static_assert(count_members<Three>() == 3);
static_assert(lists_each_number_once<Three>(std::tuple{real, truth, c}));
static_assert(!lists_each_number_once<Three>(std::tuple{real, truth}), "one is missing");
static_assert(!lists_each_number_once<Three>(std::tuple{real, truth, truth}),
              "one stands there twice in the place of the other");
static_assert(!lists_each_number_once<Three>(std::tuple{real, truth, NumberField{"b", &Three::c}}),
              "two have one name");

TEST(NumberFields, GiveTheirMembers) {
  Three three{1.5, true, 7};
  EXPECT_EQ(three.*real.number, 1.5);
  EXPECT_EQ(three.*c.number, 7);
}

}  // namespace
}  // namespace tether
