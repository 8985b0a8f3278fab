// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/border_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>
#include <utility>

namespace tether {
namespace {

using Holds = std::function<bool(double x, double y)>;  // from 0 to 1

/// A map of a rule that is known everywhere.
class SearchedMap {
 public:
  SearchedMap(std::size_t nx, std::size_t ny, Holds holds, std::size_t stride = 5,
              std::array<bool, 2> ordered = {true, true})
      : nx_(nx), ny_(ny), holds_(std::move(holds)), search_({nx, ny}, ordered, stride) {}

  /// Runs all that is wanted; `one_by_one` asks again after each, the last one first.
  void run(bool one_by_one = false) {
    std::vector<std::size_t> waiting = search_.next();
    while (!waiting.empty()) {
      const std::size_t square = one_by_one ? waiting.back() : waiting.front();
      waiting.erase(one_by_one ? waiting.end() - 1 : waiting.begin());
      EXPECT_TRUE(runs_.insert(square).second) << "it is run twice";
      search_.take(square, holds(square));
      if (one_by_one || waiting.empty()) {
        for (const std::size_t more : search_.next()) waiting.push_back(more);
      }
    }
  }
  const std::set<std::size_t>& runs() const { return runs_; }
  std::size_t wrong() const {
    std::size_t count = 0;
    const auto by = search_.deciding();
    for (std::size_t k = 0; k < by.size(); ++k) count += !by[k] || holds(*by[k]) != holds(k) ? 1 : 0;
    return count;
  }

 private:
  bool holds(std::size_t k) const {
    const auto part = [](std::size_t i, std::size_t n) {
      return n > 1 ? static_cast<double>(i) / static_cast<double>(n - 1) : 0;
    };
    return holds_(part(k % nx_, nx_), part(k / nx_, ny_));
  }

  std::size_t nx_, ny_;
  Holds holds_;
  BorderSearch search_;
  std::set<std::size_t> runs_;
};

struct Shape {
  const char* name;
  Holds holds;
  double most = 400. / 3;  ///< runs of 20 x 20
};

std::vector<Shape> shapes() {
  return {{"slope", [](double x, double y) { return y < 0.3 + 0.5 * x; }},
          {"hyperbola", [](double x, double y) { return x * y < 0.12; }},
          {"step", [](double x, double y) { return y < (x < 0.47 ? 0.2 : 0.8); }},
          {"wave", [](double x, double y) { return y < 0.5 + 0.3 * std::sin(7 * x); }},
          {"upright", [](double x, double) { return x < 0.71; }},
          {"disc", [](double x, double y) { return std::hypot(x - 0.4, y - 0.55) < 0.25; }},
          {"strip", [](double x, double y) { return std::abs(y - 0.2 - 0.6 * x) < 0.12; }, 160},  // two borders
          {"nowhere", [](double, double) { return false; }}};
}

TEST(BorderSearch, FindsTheBorderOfAllRunsByAThirdOfThem) {
  for (const Shape& shape : shapes()) {
    SCOPED_TRACE(shape.name);
    SearchedMap map(20, 20, shape.holds);
    map.run();
    EXPECT_EQ(map.wrong(), 0u);
    EXPECT_LE(static_cast<double>(map.runs().size()), shape.most);
  }
}

TEST(BorderSearch, WantsTheSameRunsInWhateverOrderTheyEnd) {
  for (const Shape& shape : shapes()) {
    SCOPED_TRACE(shape.name);
    SearchedMap all_at_once(23, 17, shape.holds), one_by_one(23, 17, shape.holds);
    all_at_once.run(), one_by_one.run(true);
    EXPECT_EQ(all_at_once.runs(), one_by_one.runs());
    EXPECT_EQ(all_at_once.wrong(), 0u);
  }
}

TEST(BorderSearch, RunsAllByAStrideOfOne) {
  SearchedMap map(7, 5, shapes()[0].holds, 1);
  map.run();
  EXPECT_EQ(map.runs().size(), 35u);
}

TEST(BorderSearch, HalvesASingleAxis) {
  for (const auto& [nx, ny] : {std::pair(65, 1), std::pair(1, 65)}) {
    SearchedMap map(
        static_cast<std::size_t>(nx), static_cast<std::size_t>(ny), [](double x, double y) { return x + y < 0.3; }, 64);
    map.run();
    EXPECT_EQ(map.wrong(), 0u);
    EXPECT_EQ(map.runs().size(), 2u + 6u);
  }
}

TEST(BorderSearch, TakesEachWordByItself) {
  const Holds by_word = [](double x, double y) { return y == 0 ? x < 0.2 : y == 1 ? x < 0.9 : x < 0.5; };
  SearchedMap map(40, 3, by_word, 10, {true, false});
  map.run();
  EXPECT_EQ(map.wrong(), 0u);
  EXPECT_LE(map.runs().size(), 3u * (5 + 4));
}

TEST(BorderSearch, DoesNotSeeAnIslandBetweenTheSquaresOfItsCoarseGrid) {
  SearchedMap map(
      21, 21, [](double x, double y) { return std::hypot(x - 0.375, y - 0.375) > 0.09; }, 5);
  map.run();
  EXPECT_EQ(map.runs().size(), 25u);
  EXPECT_GT(map.wrong(), 0u);
}

TEST(BorderSearch, SquaresWithoutAVerdictDecideNothing) {
  BorderSearch search({3, 1}, {true, true}, 1);
  EXPECT_EQ(search.next().size(), 3u);
  search.take(0, true);
  const auto by = search.deciding();
  EXPECT_EQ(by[0], 0u);
  EXPECT_FALSE(by[1]);
  EXPECT_FALSE(by[2]);
  EXPECT_TRUE(search.next().empty());
  EXPECT_FALSE(BorderSearch({2, 2}, {true, true}, 1).deciding()[3]);
}

}  // namespace
}  // namespace tether
