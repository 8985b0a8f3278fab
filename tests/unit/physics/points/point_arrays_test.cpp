// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever a point remembers moves with it when points are sorted, and comes back from a saved state.
#include <gtest/gtest.h>

#include <algorithm>

#include "physics/points/arrays.hpp"
#include "physics/points/state.hpp"
#include "unit/physics/scenes.hpp"

namespace tether::mpm {
namespace {

using namespace scenes;

/// Two solid blocks whose points stand in no order of cells.
Scene blocks() {
  Scene scene = open_scene(9, 9);
  add_block(scene, PlaneElastic{}, 1, 4, 1, 4, 3);
  add_block(scene, FiniteElastic{}, 5, 8, 2, 7, 2);
  for (const Body& body : scene.bodies) {
    const auto first = static_cast<std::ptrdiff_t>(body.first), end = first + static_cast<std::ptrdiff_t>(body.count);
    std::reverse(scene.points.x.begin() + first, scene.points.x.begin() + end);
  }
  return scene;
}

/// A number that no other point has in this array, and no other array at this point; of one byte, its lowest bit.
template <class Number>
Number mark(int array, int id) {
  return static_cast<Number>(sizeof(Number) == 1 ? (id / 3) % 2 : 1000 * array + id);
}

/// Marks all remembered arrays but the places and the numbers, by which points are sorted.
void mark_all(Points& points) {
  int array = 0;
  each_row(Points::rows(), [&](const auto& row) {
    auto& numbers = points.*row.array;
    ++array;
    if (row.name == std::string("x") || row.name == std::string("y") || row.name == std::string("id")) return;
    for (std::size_t p = 0; p < numbers.size(); ++p) {
      numbers[p] = mark<typename std::decay_t<decltype(numbers)>::value_type>(array, points.id[p]);
    }
  });
}

void expect_marks(const Points& points) {
  int array = 0;
  each_row(Points::rows(), [&](const auto& row) {
    const auto& numbers = points.*row.array;
    ++array;
    if (row.name == std::string("x") || row.name == std::string("y") || row.name == std::string("id")) return;
    for (std::size_t p = 0; p < numbers.size() && row.remembered(); ++p) {
      using Number = typename std::decay_t<decltype(numbers)>::value_type;
      EXPECT_EQ(numbers[p], mark<Number>(array, points.id[p])) << row.name << " of point " << points.id[p];
    }
  });
}

TEST(PointArrays, MoveWithTheirPointsWhenSorted) {
  const Scene scene = blocks();
  PointSet given = scene.points;
  State state(scene, given, {});
  for (const Body& body : scene.bodies) state.ranges.push_back({body.first, body.first + body.count});
  mark_all(state.points);
  const auto before = state.points.id;
  state.blocks.resize(scene.bodies.size());
  CellSort sort;
  sort_bodies(sort, state, scene);
  ASSERT_NE(state.points.id, before);
  expect_marks(state.points);
  for (std::size_t p = 0; p < state.points.size(); ++p)
    EXPECT_EQ(state.points.x[p], scene.points.x[static_cast<std::size_t>(state.points.id[p])]);
}

TEST(PointArrays, ComeBackFromASavedState) {
  const Scene scene = blocks();
  State state = start(scene), other = start(scene);
  mark_all(state.points);
  std::reverse(state.points.id.begin(), state.points.id.end());
  std::reverse(state.points.x.begin(), state.points.x.end());
  restore(other, scene, save(state));
  each_row(Points::rows(), [&](const auto& row) {
    if (row.remembered()) {
      EXPECT_EQ(other.points.*row.array, state.points.*row.array) << row.name;
    }
  });
}

}  // namespace
}  // namespace tether::mpm
