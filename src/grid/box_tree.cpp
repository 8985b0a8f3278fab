// SPDX-License-Identifier: GPL-3.0-or-later
#define BOOST_ALLOW_DEPRECATED_HEADERS  // of Boost itself
#include "grid/box_tree.hpp"

#include <algorithm>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <iterator>
#include <utility>

namespace tether {
namespace {

namespace bg = boost::geometry;
using TreePoint = bg::model::point<double, 3, bg::cs::cartesian>;
using TreeBox = bg::model::box<TreePoint>;
using TreeEntry = std::pair<TreeBox, int>;

TreeBox tree_box(const Box<3>& box, double grown) {
  return {{box.low[0] - grown, box.low[1] - grown, box.low[2] - grown},
          {box.high[0] + grown, box.high[1] + grown, box.high[2] + grown}};
}

std::vector<TreeEntry> entries_of(std::span<const Box<3>> boxes) {
  std::vector<TreeEntry> entries;
  for (const Box<3>& box : boxes) entries.emplace_back(tree_box(box, 0), static_cast<int>(entries.size()));
  return entries;
}

}  // namespace

struct BoxTree::Tree {
  bg::index::rtree<TreeEntry, bg::index::quadratic<16>> boxes;  // packed, as they all are given to it at once
};

BoxTree::BoxTree(std::span<const Box<3>> boxes) : tree_(new Tree{decltype(Tree::boxes)(entries_of(boxes))}) {}

BoxTree::BoxTree(BoxTree&&) noexcept = default;

BoxTree::~BoxTree() = default;

std::vector<int> BoxTree::meeting(const Box<3>& box, double gap) const {
  std::vector<TreeEntry> found;
  tree_->boxes.query(bg::index::intersects(tree_box(box, gap)), std::back_inserter(found));
  std::vector<int> numbers;
  for (const TreeEntry& entry : found) numbers.push_back(entry.second);
  std::ranges::sort(numbers);
  return numbers;
}

}  // namespace tether
