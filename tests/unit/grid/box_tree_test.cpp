// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/box_tree.hpp"

#include <gtest/gtest.h>
#include <random>

namespace tether {
namespace {

std::vector<Box<3>> boxes_anywhere(std::mt19937& draw, int count, double size) {
  std::uniform_real_distribution<double> place(0, 1), side(0, size);
  std::vector<Box<3>> boxes;
  for (int k = 0; k < count; ++k) {
    const Vec<3> low{place(draw), place(draw), place(draw)};
    boxes.push_back({low, {low[0] + side(draw), low[1] + side(draw), low[2] + side(draw)}});
  }
  return boxes;
}

TEST(BoxTree, FindsWhatEachBoxByItselfMeets) {
  std::mt19937 draw(7);
  const std::vector<Box<3>> boxes = boxes_anywhere(draw, 400, 0.2);
  const BoxTree tree(boxes);
  std::size_t found = 0;
  for (const Box<3>& box : boxes_anywhere(draw, 50, 0.3)) {
    for (const double gap : {0.0, 0.05}) {
      Box<3> grown = box;
      for (std::size_t i = 0; i < 3; ++i) grown.low[i] -= gap, grown.high[i] += gap;
      std::vector<int> expected;
      for (std::size_t k = 0; k < boxes.size(); ++k) {
        if (boxes[k].meets(grown)) expected.push_back(static_cast<int>(k));
      }
      EXPECT_EQ(tree.meeting(box, gap), expected);
      found += expected.size();
    }
  }
  EXPECT_GT(found, 500U);
}

TEST(BoxTree, EdgesCount) {
  const std::vector<Box<3>> boxes{{{0, 0, 0}, {1, 1, 0}}, {{2, 0, 0}, {3, 1, 0}}};
  const BoxTree tree(boxes);
  EXPECT_EQ(tree.meeting({{1, 1, 0}, {2, 1, 0}}), (std::vector<int>{0, 1}));
  EXPECT_TRUE(tree.meeting({{1.5, 0, 0}, {1.5, 1, 0}}).empty());
  EXPECT_EQ(tree.meeting({{1.5, 0, 0}, {1.5, 1, 0}}, 0.5), (std::vector<int>{0, 1}));
}

TEST(BoxTree, OfNoBoxesNothingIsMet) {
  EXPECT_TRUE(BoxTree(std::span<const Box<3>>()).meeting({{0, 0, 0}, {1, 1, 1}}, 10).empty());
}

}  // namespace
}  // namespace tether
