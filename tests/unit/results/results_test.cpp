// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/results.hpp"

#include <stdexcept>

#include "unit/results/support.hpp"

namespace tether {
namespace {

TEST(History, GivesAColumnByName) {
  const History history{test::small_layout(), {{0, 1, 2, 3, 4, 5, 6}, {10, 11, 12, 13, 14, 15, 16}}};
  EXPECT_EQ(history.column("time"), (std::vector<double>{0, 10}));
  EXPECT_EQ(history.column("body_x_2"), (std::vector<double>{3, 13}));
  EXPECT_EQ(history.column("point_vy_3"), (std::vector<double>{6, 16}));
}

TEST(History, KnowsNoOtherColumn) {
  const History history{test::small_layout(), {{0, 1, 2, 3, 4, 5, 6}}};
  EXPECT_THROW(history.column("body_x"), std::out_of_range);
  EXPECT_THROW(history.column("body_x_3"), std::out_of_range);
  EXPECT_THROW(history.column(""), std::out_of_range);
}

TEST(History, RefusesARecordThatIsTooShort) {
  const History history{test::small_layout(), {{0, 1}}};
  EXPECT_THROW(history.column("point_vy_1"), std::out_of_range);
}

}  // namespace
}  // namespace tether
