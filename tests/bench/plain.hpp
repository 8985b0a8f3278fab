// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numbers>
#include <string>
#include <vector>

// What the plain loops share: a square block of points that is stirred, in a box with a margin, their arrays and laws,
// and the clock. They are what points by lanes are measured against: scalar loops over sorted points, an array a
// property and a record a node, without walls, checks and outputs.

namespace plain {

/// What a loop is compiled for: gas or elastic points, in the plane or about an axis, with the ledger's books, with
/// membranes in the gas, whose mass is none of the gas.
struct Features {
  bool gas = false, axis = false, ledger = false, membranes = false;
};

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
  double x, y, vx, vy, vxx, vyx, vxy, vyy, area;
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

/// Those within a circle about the block's middle, the radius in sides of the block.
inline std::vector<Point> within(std::vector<Point> points, const Block& block, double x, double y, double radius) {
  const double x0 = x + Block::margin * block.h(), y0 = y + Block::margin * block.h();
  std::erase_if(points, [&](const Point& p) { return std::hypot(p.x - x0, p.y - y0) > radius; });
  return points;
}

/// Strain rates, zz the hoop's about an axis [1/time].
struct Rates {
  double xx, yy, xy, zz;
};

/// The points of a body of density 1, and their law.
template <Features f>
struct Points {
  Points(const Block& block, const std::vector<Point>& start) : h(block.h()), dt(block.dt()) {
    for (const Point& p : start) {
      const double size = f.axis ? 2 * std::numbers::pi * p.x * p.area : p.area;
      x.push_back(p.x), y.push_back(p.y), vx.push_back(p.vx), vy.push_back(p.vy), m.push_back(size);
    }
    volume = m;
    sxx.assign(x.size(), 0), syy = sxy = sxx;
    if (f.axis) szz = sxx;
    if (f.gas) rho.assign(x.size(), 1), e = rho;  // so cold that it keeps its place
    own = 1.35 * block.modulus(), other = 0.58 * block.modulus(), shear = 0.77 * block.modulus();
  }
  std::size_t size() const { return x.size(); }

  /// Stress of an elastic point, or of gas whose density is known.
  void stress(std::size_t p, const Rates& d) {
    const double rate = d.xx + d.yy + d.zz;
    if constexpr (f.gas) {
      const double c = std::sqrt(0.56 * e[p]);
      const double q = rate < 0 ? rho[p] * (h * h * rate * rate - h * c * rate) : 0;
      const double mean = -0.4 * rho[p] * e[p] - q - viscosity * 2 / 3 * rate;
      sxx[p] = mean + 2 * viscosity * d.xx, syy[p] = mean + 2 * viscosity * d.yy, sxy[p] = 2 * viscosity * d.xy;
      if constexpr (f.axis) szz[p] = mean + 2 * viscosity * d.zz;
      volume[p] = m[p] / rho[p];
    } else {
      sxx[p] += dt * (own * d.xx + other * (d.yy + d.zz)), syy[p] += dt * (other * (d.xx + d.zz) + own * d.yy);
      if constexpr (f.axis) szz[p] += dt * (own * d.zz + other * (d.xx + d.yy));
      sxy[p] += dt * shear * d.xy;
    }
  }
  void heat(std::size_t p, const Rates& d) {
    double power = sxx[p] * d.xx + syy[p] * d.yy + 2 * sxy[p] * d.xy;
    if constexpr (f.axis) power += szz[p] * d.zz;
    e[p] += dt * power / rho[p];
  }
  void note_wave(std::size_t p) {
    wave = std::max(wave, std::sqrt(0.56 * e[p]) + std::sqrt(vx[p] * vx[p] + vy[p] * vy[p]));
  }

  static constexpr double viscosity = 1e-3;
  double h, dt, own = 0, other = 0, shear = 0, wave = 0;
  std::vector<double> x, y, vx, vy, m, volume, e, rho, sxx, syy, sxy, szz;
};

/// What a step must not change: of the nodes, the sum of |m v| for a scale, and where the ledger is kept the energy.
struct Totals {
  double mass = 0, px = 0, py = 0, scale = 0, energy = 0;
  double lost = 0;       // energy that impulses of contact took since the start
  bool keeps_px = true;  // about an axis it is no momentum
};

/// Of the process [s].
inline double cpu() {
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Largest relative change of what must not change.
inline double drift(const Totals& a, const Totals& b) {
  const double mass = std::abs(b.mass - a.mass) / a.mass, y = std::abs(b.py - a.py) / a.scale;
  const double x = a.keeps_px ? std::abs(b.px - a.px) / a.scale : 0;
  const double energy = a.energy > 0 ? std::abs(b.energy - a.energy) / a.energy : 0;
  return std::max({mass, x, y, energy});
}

/// Steps in rounds of up to 1e6 point-steps; prints the best round [ns a point-step] and what the steps kept. 1 where
/// they did not: of so many roundings 1e-10 is far more than is to be expected.
template <class Run>
int time_rounds(Run& run, std::size_t points, int rounds) {
  const int steps = std::clamp(static_cast<int>(1'000'000 / points), 3, 100);  // fewer than leave the margin
  const Totals before = run.totals();
  run.step();
  double best = 1e300;
  for (int round = 0; round < rounds; ++round) {
    const double begin = cpu();
    for (int k = 0; k < steps; ++k) run.step();
    best = std::min(best, (cpu() - begin) / steps / static_cast<double>(points) * 1e9);
  }
  const Totals after = run.totals();
  const double changed = drift(before, after);
  std::printf("%.2f ns  %zu points  mass %.17g  momentum %.17g %.17g  energy %.17g  lost %.17g  drift %.3g\n", best,
              points, after.mass, after.px, after.py, after.energy, after.lost, changed);
  return changed < 1e-10 ? 0 : 1;
}

/// What follows the kind of loop on the command line: [cells [points of a cell's side [jitter [rounds]]]]
struct Words {
  std::string kind;
  Block block;
  int rounds = 7;
  Words(int argc, char** argv) {
    if (argc > 1) kind = argv[1];
    block.gas = kind.starts_with("gas");
    if (argc > 2) block.cells = std::atoi(argv[2]);
    if (argc > 3) block.per_side = std::atoi(argv[3]);
    if (argc > 4) block.jitter = std::atof(argv[4]);
    if (argc > 5) rounds = std::atoi(argv[5]);
  }
};

template <class Loop>
int time_loop(const Words& words) {
  Loop run(words.block);
  return time_rounds(run, run.size(), words.rounds);
}

}  // namespace plain
