// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/vec.hpp"

namespace tether {

/// Finds which of many boxes, all known at once, meet another one: a tree of Boost's, compiled here once, since it
/// costs the compiler seconds. In the plane the third direction is 0.
class BoxTree {
 public:
  explicit BoxTree(std::span<const Box<3>> boxes);
  BoxTree(BoxTree&&) noexcept;
  ~BoxTree();

  /// The numbers, ascending, of those that have a place in common with a box that has grown by `gap` on all sides
  /// [length], be it of their edges.
  std::vector<int> meeting(const Box<3>& box, double gap = 0) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace tether
