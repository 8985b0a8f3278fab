// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/column_text.hpp"

#include <gtest/gtest.h>

namespace tether {
namespace {

using Names = std::vector<std::string>;

HistoryLayout layout() {
  return {{{"time", Dimension::time, "time"},
           {"energy_total", Dimension::energy, "sum of the energies"},
           {"body_x", Dimension::length, "centre of mass, x", Per::body},
           {"point_vy", Dimension::velocity, "velocity, y", Per::point}},
          {"disc", "plate"},
          {"point 1", "point 7", "point 9"}};
}

TEST(HistoryLayout, CountsScenesBodiesAndPoints) {
  const auto of = layout();
  EXPECT_EQ(of.count(of.quantities[1]), 1u);
  EXPECT_EQ(of.count(of.quantities[2]), 2u);
  EXPECT_EQ(of.count(of.quantities[3]), 3u);
}

TEST(HistoryLayout, NamesColumnsFromOne) {
  EXPECT_EQ(layout().column_names(),
            (Names{"time", "energy_total", "body_x_1", "body_x_2", "point_vy_1", "point_vy_2", "point_vy_3"}));
}

TEST(HistoryLayout, NumbersASingleBodyToo) {
  auto of = layout();
  of.body_names.resize(1);
  of.point_names.clear();
  EXPECT_EQ(of.column_names(), (Names{"time", "energy_total", "body_x_1"}));
}

}  // namespace
}  // namespace tether
