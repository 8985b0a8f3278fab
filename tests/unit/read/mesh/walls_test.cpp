// SPDX-License-Identifier: GPL-3.0-or-later
// Walls of the grid hold the nodes of a mesh that stand at them.
#include <gtest/gtest.h>

#include "model/solids.hpp"
#include "unit/read/scene_support.hpp"

namespace tether::test {
namespace {

/// A block at the left edge of the grid; `z` is what $mesh says of its depth.
Built at_the_left(int wall, const std::string& z = "") {
  return build_on_mesh(on_unit_square("wl=" + std::to_string(wall) +
                                      "\n$\n$reg nreg=1,nvi=4\nxvi(1,1)=0.,.5,.5,0.\nyvi(1,1)=.25,.25,.75,.75\n"
                                      "densir=3.,matr(1,1)=10.,.25 $\n$mesh " +
                                      z + " $\n"));
}

std::array<bool, 3> held(const Built& built) { return built.scene.solids()->supports.at(0).fixed; }

TEST(WallsOfAMesh, HoldWhatIsAtThem) {
  const std::string deep = "cells(1,1)=1,1,1,z(1,1)=0.,1.";
  EXPECT_EQ(held(at_the_left(0)), (std::array{true, true, false}));
  EXPECT_EQ(held(at_the_left(0, deep)), (std::array{true, true, true}));
  EXPECT_EQ(held(at_the_left(4)), (std::array{true, false, false}));
  EXPECT_EQ(held(at_the_left(4, deep)), (std::array{true, false, false}));
  EXPECT_TRUE(at_the_left(1).scene.solids()->supports.empty());
}

}  // namespace
}  // namespace tether::test
