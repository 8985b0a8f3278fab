// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "plain.hpp"

// The robust step's pieces as plain loops: stress first, APIC, quadratic splines at nodes; one record a node.

namespace plain {

struct Sums {
  double px, py, fx, fy, m, gas;  // gas: its mass, where others have some, too; pairs stand at even places
};
struct Pair {
  double x, y;
};

/// Weights and slopes of the nodes before, at and after a place along an axis.
struct Axis {
  std::array<double, 3> w, g;
  explicit Axis(double r)
      : w{0.5 * (0.5 - r) * (0.5 - r), 0.75 - r * r, 0.5 * (0.5 + r) * (0.5 + r)}, g{r - 0.5, -2 * r, r + 0.5} {}
};
/// The first of a place's nine nodes, the place from the middle one, and the weights.
struct At {
  std::size_t node;
  double r, s;
  Axis x, y;
};
/// A velocity and its slopes, by x and by y.
struct Field {
  double vx, vy, xx, yx, xy, yy;
};

template <Features f>
struct Nodes {
  explicit Nodes(const Block& block) : nx(block.nodes()), h(block.h()), per_h(1 / block.h()) {
    const std::size_t count = static_cast<std::size_t>(nx) * static_cast<std::size_t>(nx);
    sums.assign(count, Sums{}), old.resize(count), now.resize(count);
    if (f.gas) density.assign(count, 0);
    if (f.ledger) squares.assign(count, 0), loss = heat = squares;
    if (!f.axis) return;
    for (std::size_t n = 0; n < count; ++n)
      per_volume.push_back(per_h * per_h / (2 * std::numbers::pi * static_cast<double>(n % width()) * h));
  }
  std::size_t width() const { return static_cast<std::size_t>(nx); }

  /// Velocities, densities, and the ledger's heat a mass of the gas; forces are cleared.
  void begin() {
    for (std::size_t n = 0; n < sums.size(); ++n) {
      Sums& s = sums[n];
      const double per_m = s.m > 0 ? 1 / s.m : 0;
      old[n] = {s.px * per_m, s.py * per_m}, s.fx = s.fy = 0;
      const double gas = f.membranes ? s.gas : s.m;
      if constexpr (f.gas && f.axis) density[n] = gas * per_volume[n];
      if constexpr (f.gas && !f.axis) density[n] = gas * per_h * per_h;
      if constexpr (f.ledger) heat[n] = loss[n] * per_m;
    }
  }
  /// The momentum equation; sums are cleared.
  void solve(double dt) {
    for (std::size_t n = 0; n < sums.size(); ++n) {
      Sums& s = sums[n];
      const double per_m = s.m > 0 ? 1 / s.m : 0;
      const Pair u = now[n] = {old[n].x + dt * s.fx * per_m, old[n].y + dt * s.fy * per_m};
      s.m = s.px = s.py = 0;
      if constexpr (f.membranes) s.gas = 0;
      if constexpr (f.ledger) {
        squares[n] = old[n].x * old[n].x + old[n].y * old[n].y + u.x * u.x + u.y * u.y, loss[n] = 0;
      }
    }
  }
  void add_to(Totals& totals) const {
    totals.keeps_px = !f.axis;
    for (const Sums& s : sums)
      totals.mass += s.m, totals.px += s.px, totals.py += s.py, totals.scale += std::hypot(s.px, s.py);
    if constexpr (f.ledger)
      for (const double l : loss) totals.energy += l;
  }

  At at(double x, double y) const {
    const double a = x * per_h, b = y * per_h;
    const int i = static_cast<int>(a + 0.5), j = static_cast<int>(b + 0.5);
    return {static_cast<std::size_t>((j - 1) * nx + i - 1), a - i, b - j, Axis(a - i), Axis(b - j)};
  }
  std::size_t row(const At& at, std::size_t l) const { return at.node + l * width(); }

  /// sum_i N_i q_i
  double value(const At& at, const std::vector<double>& q) const {
    double value = 0;
    for (std::size_t l = 0; l < 3; ++l) {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k) sum += at.x.w[k] * q[row(at, l) + k];
      value += at.y.w[l] * sum;
    }
    return value;
  }
  /// Strain rates of a field of the nodes, at the radius x.
  template <class Velocity>
  Rates rates(const At& at, double x, const Velocity& velocity) const {
    double xx = 0, xy = 0, yx = 0, yy = 0, vr = 0;
    for (std::size_t l = 0; l < 3; ++l) {
      double gx = 0, wx = 0, gy = 0, wy = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Pair v = velocity(row(at, l) + k);
        gx += at.x.g[k] * v.x, wx += at.x.w[k] * v.x, gy += at.x.g[k] * v.y, wy += at.x.w[k] * v.y;
      }
      xx += at.y.w[l] * gx, xy += at.y.g[l] * wx, yx += at.y.w[l] * gy, yy += at.y.g[l] * wy;
      if constexpr (f.axis) vr += at.y.w[l] * wx;
    }
    return {per_h * xx, per_h * yy, 0.5 * (per_h * xy + per_h * yx), f.axis ? vr / x : 0};
  }
  /// The field of velocities that is linear about the place.
  Field field(const At& at, const std::vector<Pair>& velocities) const {
    Field v{};
    for (std::size_t l = 0; l < 3; ++l) {
      double ux = 0, uy = 0, mx = 0, my = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Pair u = velocities[row(at, l) + k];
        const double e = (static_cast<double>(k) - 1 - at.r) * at.x.w[k];
        ux += at.x.w[k] * u.x, uy += at.x.w[k] * u.y, mx += e * u.x, my += e * u.y;
      }
      ux *= at.y.w[l], uy *= at.y.w[l];
      const double e = static_cast<double>(l) - 1 - at.s;
      v.vx += ux, v.vy += uy, v.xx += at.y.w[l] * mx, v.yx += at.y.w[l] * my, v.xy += e * ux, v.yy += e * uy;
    }
    v.xx *= 4 * per_h, v.yx *= 4 * per_h, v.xy *= 4 * per_h, v.yy *= 4 * per_h;
    return v;
  }

  int nx;
  double h, per_h;
  std::vector<Sums> sums;
  std::vector<Pair> old, now;
  std::vector<double> density, per_volume, squares, loss, heat;
};

/// A body's points and what a step does to them, by F; the nodes are compiled for `of_nodes`.
template <Features f, Features of_nodes = f>
struct Body {
  using Grid = Nodes<of_nodes>;
  Body(const Block& block, const std::vector<Point>& start) : P(block, start) {
    for (const Point& p : start) vxx.push_back(p.vxx), vyx.push_back(p.vyx), vxy.push_back(p.vxy), vyy.push_back(p.vyy);
    if (f.ledger) lost.assign(P.size(), 0);
  }
  std::size_t size() const { return P.size(); }
  At at(std::size_t p, const Grid& nodes) const { return nodes.at(P.x[p], P.y[p]); }

  /// Strain rate, stress and force.
  void pull(std::size_t p, const At& here, Grid& nodes) {
    if constexpr (f.gas) P.rho[p] = nodes.value(here, nodes.density);
    if constexpr (f.ledger) P.e[p] += nodes.value(here, nodes.heat);
    P.stress(p, nodes.rates(here, P.x[p], [&](std::size_t n) { return nodes.old[n]; }));
    const double v = -P.volume[p] * nodes.per_h, xx = v * P.sxx[p], yy = v * P.syy[p], xy = v * P.sxy[p];
    double hoop = 0;
    if constexpr (f.axis) hoop = -P.volume[p] * P.szz[p] / P.x[p];
    for (std::size_t l = 0; l < 3; ++l) {
      const double a = here.y.w[l] * xx, c = here.y.w[l] * xy, d = here.y.g[l] * yy;
      const double b = f.axis ? here.y.g[l] * xy + here.y.w[l] * hoop : here.y.g[l] * xy;
      Sums* sums = &nodes.sums[nodes.row(here, l)];
      for (std::size_t k = 0; k < 3; ++k) {
        sums[k].fx += here.x.g[k] * a + here.x.w[k] * b, sums[k].fy += here.x.g[k] * c + here.x.w[k] * d;
      }
    }
  }
  /// v . v' + C : C' h^2/4 of two fields.
  static double product(const Field& a, const Field& b, double h) {
    return a.vx * b.vx + a.vy * b.vy + 0.25 * h * h * (a.xx * b.xx + a.yx * b.yx + a.xy * b.xy + a.yy * b.yy);
  }
  Field own(std::size_t p) const { return {P.vx[p], P.vy[p], vxx[p], vyx[p], vxy[p], vyy[p]}; }

  /// Heat of gas, velocity, place, mass and momentum.
  void move(std::size_t p, Grid& nodes) {
    const At here = at(p, nodes);
    if constexpr (f.gas) {
      P.heat(p, nodes.rates(here, P.x[p], [&](std::size_t n) {
        return Pair{0.5 * (nodes.old[n].x + nodes.now[n].x), 0.5 * (nodes.old[n].y + nodes.now[n].y)};
      }));
    }
    const Field v = nodes.field(here, nodes.now);
    if constexpr (f.ledger) {  // what the way to the nodes and back costs of the kinetic energy, per mass
      const Field given = own(p), old = nodes.field(here, nodes.old);
      lost[p] = 0.5 * (product(given, given, nodes.h) - 2 * product(given, old, nodes.h) - product(v, v, nodes.h) +
                       nodes.value(here, nodes.squares));
    }
    P.vx[p] = v.vx, P.vy[p] = v.vy, vxx[p] = v.xx, vyx[p] = v.yx, vxy[p] = v.xy, vyy[p] = v.yy;
    P.x[p] += P.dt * v.vx, P.y[p] += P.dt * v.vy;
    if constexpr (f.gas) P.note_wave(p);
    map(p, nodes);
  }
  void map(std::size_t p, Grid& nodes) {
    const At here = at(p, nodes);
    const double h = nodes.h, step_x = vxx[p] * h, step_y = vyx[p] * h;
    for (std::size_t l = 0; l < 3; ++l) {
      const double e = (static_cast<double>(l) - 1 - here.s) * h, wy = here.y.w[l] * P.m[p];
      double ux = P.vx[p] - (1 + here.r) * step_x + e * vxy[p], uy = P.vy[p] - (1 + here.r) * step_y + e * vyy[p];
      const std::size_t first = nodes.row(here, l);
      Sums* sums = &nodes.sums[first];
      for (std::size_t k = 0; k < 3; ++k) {
        const double w = wy * here.x.w[k];
        sums[k].m += w, sums[k].px += w * ux, sums[k].py += w * uy;
        if constexpr (f.gas && of_nodes.membranes) sums[k].gas += w;
        if constexpr (f.ledger) nodes.loss[first + k] += w * lost[p];
        ux += step_x, uy += step_y;
      }
    }
  }
  void add_energy_to(Totals& totals, double h) const {
    for (std::size_t p = 0; p < size(); ++p) totals.energy += P.m[p] * (P.e[p] + 0.5 * product(own(p), own(p), h));
  }

  Points<f> P;
  std::vector<double> vxx, vyx, vxy, vyy, lost;
};

}  // namespace plain
