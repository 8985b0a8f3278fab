// SPDX-License-Identifier: GPL-3.0-or-later
// Cost of a pair in contact: its forces with their derivatives, of each kind, without (0) and with (1) friction and
// damping. Pairs lie in regions of all kinds, and move little, as in a step, or far.
#include <benchmark/benchmark.h>

#include <cstddef>
#include <random>
#include <vector>

#include "physics/contact/pair_force.hpp"

namespace {

using namespace tether;
using namespace tether::contact;

constexpr std::size_t pair_count = 1024;
constexpr PairScale scale{.strength = 3, .gap2 = 0.16, .parallel = 0.3};

template <PairKind kind, int dim>
struct PairOfStep {
  PairVectors<dim, vector_count(kind)> r0, r1;
  double s0, s1;
};

template <PairKind kind, int dim>
double square_of(const PairVectors<dim, vector_count(kind)>& r) {
  constexpr int count = vector_count(kind);
  return squared_distance<dim, count>(r, nearest<kind>(products_of<dim, count>(r)));
}

/// The first vector is a sum of the others, and a little way off it.
template <PairKind kind, int dim>
PairOfStep<kind, dim> random_pair(std::mt19937& random) {
  constexpr int count = vector_count(kind);
  std::uniform_real_distribution<double> side(-1, 1), along(-0.4, 1.4), way(0, 1);
  PairOfStep<kind, dim> pair;
  do {
    for (int i = 0; i < dim; ++i) pair.r0(i, 0) = 0.2 * side(random);
    for (int j = 1; j < count; ++j) {
      const double part = (kind == PairKind::edges && j == 2 ? -1 : 1) * along(random);
      for (int i = 0; i < dim; ++i) {
        pair.r0(i, j) = side(random);
        pair.r0(i, 0) += part * pair.r0(i, j);
      }
    }
    const double far = way(random) < 0.5 ? 1e-4 : 0.1;
    for (int j = 0; j < count; ++j) {
      for (int i = 0; i < dim; ++i) pair.r1(i, j) = pair.r0(i, j) + far * side(random);
    }
    pair.s0 = square_of<kind, dim>(pair.r0), pair.s1 = square_of<kind, dim>(pair.r1);
  } while (pair.s0 < 1e-4 || pair.s1 < 1e-4 || (pair.s0 > scale.gap2 && pair.s1 > scale.gap2));
  return pair;
}

template <PairKind kind, int dim>
void pair(benchmark::State& bench) {
  std::mt19937 random(7);
  std::vector<PairOfStep<kind, dim>> pairs;
  for (std::size_t k = 0; k < pair_count; ++k) pairs.push_back(random_pair<kind, dim>(random));
  const bool rubs = bench.range(0) == 1;
  const PairRule rule{.damped = rubs, .friction = rubs ? 0.3 : 0, .come_up = 0.01, .with_slopes = true};
  std::size_t k = 0;
  for (auto _ : bench) {
    const PairOfStep<kind, dim>& one = pairs[k++ % pair_count];
    benchmark::DoNotOptimize(pair_force<kind, dim>(rule, scale, one.r0, one.r1, one.s0, one.s1));
  }
}

BENCHMARK(pair<PairKind::corner, 2>)->Arg(0)->Arg(1);
BENCHMARK(pair<PairKind::edge, 2>)->Arg(0)->Arg(1);
BENCHMARK(pair<PairKind::corner, 3>)->Arg(0)->Arg(1);
BENCHMARK(pair<PairKind::edge, 3>)->Arg(0)->Arg(1);
BENCHMARK(pair<PairKind::triangle, 3>)->Arg(0)->Arg(1);
BENCHMARK(pair<PairKind::edges, 3>)->Arg(0)->Arg(1);

}  // namespace

BENCHMARK_MAIN();
