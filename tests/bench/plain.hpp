// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

// What the plain loops share: a square block of points that is stirred, in a box with a margin, and the clock.

namespace plain {

/// Points of a square block, sorted by cells, and the numbers of its material. Sides are in cells of side h.
struct Block {
  int cells = 100, per_side = 2;  // points of a cell along an axis
  double jitter = 0;              // of their distance
  bool gas = false;

  static constexpr int margin = 8;
  double h() const { return 1.0 / cells; }
  int nodes() const { return cells + 2 * margin; }
  double modulus() const { return 1e3; }
  double sound_speed() const { return std::sqrt(gas ? 1.4 * 0.4 * 2.5 * modulus() : 1.35 * modulus()); }
  double dt() const { return 0.1 * h() / sound_speed(); }
};

struct Point {
  double x, y, vx, vy, vxx, vyx, vxy, vyy, mass;
};

/// In the order of the cells, then of the rows in each.
inline std::vector<Point> points_of(const Block& block) {
  std::vector<Point> points;
  unsigned long long seed = 88172645463325252ULL;
  const auto random = [&] {  // -0.5 to 0.5
    seed ^= seed << 13, seed ^= seed >> 7, seed ^= seed << 17;
    return static_cast<double>(seed >> 11) / 9007199254740992.0 - 0.5;
  };
  const double d = block.h() / block.per_side, w = 0.05 * block.sound_speed();
  for (int j = 0; j < block.cells; ++j)
    for (int i = 0; i < block.cells; ++i)
      for (int b = 0; b < block.per_side; ++b)
        for (int a = 0; a < block.per_side; ++a) {
          const double x = i * block.h() + (a + 0.5 + block.jitter * random()) * d;
          const double y = j * block.h() + (b + 0.5 + block.jitter * random()) * d;
          points.push_back({x + Block::margin * block.h(), y + Block::margin * block.h(),
                            w * std::sin(6 * x) * std::cos(5 * y), w * std::cos(4 * x) * std::sin(7 * y),
                            6 * w * std::cos(6 * x) * std::cos(5 * y), -4 * w * std::sin(4 * x) * std::sin(7 * y),
                            -5 * w * std::sin(6 * x) * std::sin(5 * y), 7 * w * std::cos(4 * x) * std::cos(7 * y),
                            d * d});
        }
  return points;
}

/// Of the process [s].
inline double cpu() {
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Steps in rounds of at least 50 ms; prints the best round [ns a point-step] and a sum that no compiler can leave out.
template <class Run>
void time_rounds(Run& run, std::size_t points, int rounds) {
  const int steps = std::max(3, static_cast<int>(1'000'000 / points));
  run.step();
  double best = 1e300;
  for (int round = 0; round < rounds; ++round) {
    const double begin = cpu();
    for (int k = 0; k < steps; ++k) run.step();
    best = std::min(best, (cpu() - begin) / steps / static_cast<double>(points) * 1e9);
  }
  std::printf("%.2f ns  %zu points  sum %.17g\n", best, points, run.sum());
}

/// PROGRAM elastic|gas [cells [points of a cell's side [jitter [rounds]]]]
template <template <bool> class Loop>
int main_of(int argc, char** argv) {
  Block block;
  if (argc > 1) block.gas = std::string(argv[1]) == "gas";
  if (argc > 2) block.cells = std::atoi(argv[2]);
  if (argc > 3) block.per_side = std::atoi(argv[3]);
  if (argc > 4) block.jitter = std::atof(argv[4]);
  const int rounds = argc > 5 ? std::atoi(argv[5]) : 7;
  const std::size_t points = points_of(block).size();
  if (block.gas) {
    Loop<true> run(block);
    time_rounds(run, points, rounds);
  } else {
    Loop<false> run(block);
    time_rounds(run, points, rounds);
  }
  return 0;
}

}  // namespace plain
