// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/contact/pair_distance.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "grid/contact/distance_slopes.hpp"
#include "grid/contact/pairs.hpp"

namespace tether {
namespace {

template <int count>
PairVectors<3, count> random_vectors(std::mt19937& random) {
  std::uniform_real_distribution<double> side(-1, 1);
  PairVectors<3, count> r;
  for (int j = 0; j < count; ++j) {
    for (int i = 0; i < 3; ++i) r(i, j) = side(random);
  }
  return r;
}

template <PairKind kind>
double distance_of(const PairVectors<3, vector_count(kind)>& r) {
  constexpr int count = vector_count(kind);
  return std::sqrt(squared_distance<3, count>(r, nearest<kind>(products_of<3, count>(r))));
}

/// The least distance over many places of the pair: of a triangle those with s + t <= 1, of edges all.
template <PairKind kind>
double least_of_samples(const PairVectors<3, vector_count(kind)>& r) {
  constexpr int parts = 200;
  double least = INFINITY;
  for (int i = 0; i <= parts; ++i) {
    for (int j = 0; j <= (kind == PairKind::edge ? 0 : kind == PairKind::triangle ? parts - i : parts); ++j) {
      const double s = static_cast<double>(i) / parts, t = static_cast<double>(j) / parts;
      SmallMatrix<3, 1> way = r.col(0) - s * r.col(1);
      if constexpr (kind == PairKind::triangle) way -= t * r.col(2);
      if constexpr (kind == PairKind::edges) way += t * r.col(2);
      least = std::min(least, way.norm());
    }
  }
  return least;
}

template <PairKind kind>
void is_the_least() {
  std::mt19937 random(5);
  for (int k = 0; k < 300; ++k) {
    const auto r = random_vectors<vector_count(kind)>(random);
    const double found = distance_of<kind>(r), sampled = least_of_samples<kind>(r);
    EXPECT_LE(found, sampled + 1e-12);
    EXPECT_GE(found, sampled - 0.03);  // the samples are 1/200 of sides of up to 3.5 apart
  }
}

TEST(PairDistance, IsTheLeastOfAllPlaces) {
  is_the_least<PairKind::edge>();
  is_the_least<PairKind::triangle>();
  is_the_least<PairKind::edges>();
}

/// First and second derivatives by the products against central differences, where no region begins.
template <PairKind kind>
void has_its_derivatives() {
  constexpr int count = vector_count(kind);
  constexpr double h = 1e-5;
  std::mt19937 random(9);
  const auto value = [](const Products<count>& g) {
    const DistanceSlopes<count> slopes = distance_slopes<count>(g, nearest<kind>(g));
    return slopes.first.dot(g);  // the square is of first order in the products
  };
  for (int k = 0; k < 200; ++k) {
    const auto r = random_vectors<count>(random);
    const Products<count> g = products_of<3, count>(r);
    const DistanceSlopes<count> slopes = distance_slopes<count>(g, nearest<kind>(g));
    EXPECT_NEAR(value(g), std::pow(distance_of<kind>(r), 2), 1e-9 * (1 + g.norm()));
    for (int i = 0; i < product_count<count>; ++i) {
      Products<count> more = g, less = g;
      more[i] += h, less[i] -= h;
      if (nearest<kind>(more).used != nearest<kind>(less).used) continue;
      const auto slope_more = distance_slopes<count>(more, nearest<kind>(more)).first;
      const auto slope_less = distance_slopes<count>(less, nearest<kind>(less)).first;
      const Products<count> second = (slope_more - slope_less) / (2 * h);
      const double size = 1 + slopes.second.norm();
      EXPECT_NEAR((value(more) - value(less)) / (2 * h), slopes.first[i], 1e-4 * size * size);
      EXPECT_NEAR((second - slopes.second.col(i)).norm(), 0, 1e-4 * size * size);
    }
  }
}

TEST(PairDistance, HasItsDerivatives) {
  has_its_derivatives<PairKind::edge>();
  has_its_derivatives<PairKind::triangle>();
}

/// Places that fly through each other stop before they meet, and go nearly as far as they may.
TEST(PairDistance, StopsPairsOnTheirWay) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> side(-1, 1);
  int stopped = 0;
  for (const PairKind kind : {PairKind::corner, PairKind::edge, PairKind::triangle, PairKind::edges}) {
    for (int k = 0; k < 300; ++k) {
      ContactPair pair;
      pair.kind = kind, pair.places = {0, 1, 2, 3};
      std::array<double, 12> x, ways, there;
      for (double& one : x) one = side(random);
      for (double& one : ways) one = 4 * side(random);
      const double start = std::sqrt(squared_distance(pair, 3, x)), to = 0.4 * start;
      const double part = part_of_way(pair, 3, x, ways, to);
      const auto away = [&](double at) {
        for (std::size_t i = 0; i < x.size(); ++i) there[i] = x[i] + at * ways[i];
        return std::sqrt(squared_distance(pair, 3, there));
      };
      for (int i = 0; i <= 100; ++i) EXPECT_GE(away(part * i / 100), 0.8 * to * (1 - 1e-12));
      stopped += part < 1 ? 1 : 0;
      EXPECT_TRUE(part >= 1 || away(part) <= to);
    }
  }
  EXPECT_GT(stopped, 100);
}

}  // namespace
}  // namespace tether
