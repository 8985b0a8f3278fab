// SPDX-License-Identifier: GPL-3.0-or-later
// The thesis' step as a plain loop: velocities mapped back before the stress, FLIP, bilinear functions; arrays a
// property of the points, one record a node, points sorted by cells, one after the other. What points by lanes are
// measured against: no walls, one body, nothing booked and nothing checked.
#include <array>

#include "plain.hpp"

namespace {

struct Sums {
  double px, py, fx, fy, m, unused;  // with it pairs stand at even places, which is faster
};
struct Motion {
  double ax, ay, ux, uy;
};
struct Pair {
  double x, y;
};

template <bool gas>
class Thesis {
 public:
  explicit Thesis(const plain::Block& block)
      : dt_(block.dt()), h_(block.h()), per_h_(1 / block.h()), nx_(block.nodes()) {
    for (const plain::Point& p : points_of(block)) {
      x_.push_back(p.x), y_.push_back(p.y), vx_.push_back(p.vx), vy_.push_back(p.vy);
      m_.push_back(p.mass), volume_.push_back(p.mass);
    }
    e_.assign(x_.size(), 1);  // so cold that it keeps its place
    rho_ = e_;
    sxx_.assign(x_.size(), 0), syy_ = sxy_ = sxx_;
    own_ = 1.35 * block.modulus(), other_ = 0.58 * block.modulus(), shear_ = 0.77 * block.modulus();
    const std::size_t nodes = static_cast<std::size_t>(nx_) * static_cast<std::size_t>(nx_);
    sums_.assign(nodes, Sums{}), motion_.resize(nodes), convected_.resize(nodes);
    for (std::size_t p = 0; p < x_.size(); ++p) map(p);
  }
  void step() {
    for (std::size_t n = 0; n < sums_.size(); ++n) {
      const Sums& s = sums_[n];
      const double per_m = s.m > 0 ? 1 / s.m : 0, ax = s.fx * per_m, ay = s.fy * per_m;
      motion_[n] = {ax, ay, s.px * per_m + dt_ * ax, s.py * per_m + dt_ * ay};
      convected_[n] = {0, 0};
    }
    for (std::size_t p = 0; p < x_.size(); ++p) accelerate(p);
    for (std::size_t n = 0; n < sums_.size(); ++n) {
      const double per_m = sums_[n].m > 0 ? 1 / sums_[n].m : 0;
      convected_[n].x *= per_m, convected_[n].y *= per_m;
      sums_[n] = {};
    }
    for (std::size_t p = 0; p < x_.size(); ++p) strain_and_move(p), map(p);
  }
  double sum() const {
    double sum = wave_;
    for (std::size_t p = 0; p < x_.size(); ++p) sum += x_[p] + sxy_[p];
    return sum;
  }

 private:
  struct At {
    std::array<std::size_t, 4> nodes;
    double r, s;
    std::array<double, 4> N;
  };
  At at(std::size_t p) const {
    const double a = x_[p] * per_h_, b = y_[p] * per_h_;
    const int i = static_cast<int>(a), j = static_cast<int>(b);
    const double r = a - i, s = b - j;
    const auto n = static_cast<std::size_t>(j * nx_ + i), nx = static_cast<std::size_t>(nx_);
    return {{n, n + 1, n + nx + 1, n + nx}, r, s, {(1 - r) * (1 - s), r * (1 - s), r * s, (1 - r) * s}};
  }
  void accelerate(std::size_t p) {
    const At here = at(p);
    double ax = 0, ay = 0;
    for (std::size_t k = 0; k < 4; ++k)
      ax += here.N[k] * motion_[here.nodes[k]].ax, ay += here.N[k] * motion_[here.nodes[k]].ay;
    vx_[p] += dt_ * ax, vy_[p] += dt_ * ay;
    const double px = m_[p] * vx_[p], py = m_[p] * vy_[p];
    for (std::size_t k = 0; k < 4; ++k)
      convected_[here.nodes[k]].x += here.N[k] * px, convected_[here.nodes[k]].y += here.N[k] * py;
  }
  void strain_and_move(std::size_t p) {
    const At here = at(p);
    std::array<Pair, 4> v;
    double ux = 0, uy = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      v[k] = convected_[here.nodes[k]];
      ux += here.N[k] * motion_[here.nodes[k]].ux, uy += here.N[k] * motion_[here.nodes[k]].uy;
    }
    const double r = here.r, s = here.s;
    const double xx = ((v[1].x - v[0].x) * (1 - s) + (v[2].x - v[3].x) * s) * per_h_;
    const double xy = ((v[3].x - v[0].x) * (1 - r) + (v[2].x - v[1].x) * r) * per_h_;
    const double yx = ((v[1].y - v[0].y) * (1 - s) + (v[2].y - v[3].y) * s) * per_h_;
    const double yy = ((v[3].y - v[0].y) * (1 - r) + (v[2].y - v[1].y) * r) * per_h_;
    x_[p] += dt_ * ux, y_[p] += dt_ * uy;
    stress(p, xx, yy, 0.5 * (xy + yx));
  }
  void stress(std::size_t p, double xx, double yy, double xy) {
    if constexpr (gas) {
      const double rate = xx + yy;
      rho_[p] /= 1 + dt_ * rate;
      const double c = std::sqrt(0.56 * e_[p]);
      const double q = rate < 0 ? rho_[p] * (h_ * h_ * rate * rate - h_ * c * rate) : 0;
      const double mean = -0.4 * rho_[p] * e_[p] - q - viscosity * 2 / 3 * rate;
      sxx_[p] = mean + 2 * viscosity * xx, syy_[p] = mean + 2 * viscosity * yy, sxy_[p] = 2 * viscosity * xy;
      e_[p] += dt_ * (sxx_[p] * xx + syy_[p] * yy + 2 * sxy_[p] * xy) / rho_[p];
      volume_[p] = m_[p] / rho_[p];
      wave_ = std::max(wave_, std::sqrt(0.56 * e_[p]) + std::sqrt(vx_[p] * vx_[p] + vy_[p] * vy_[p]));
    } else {
      sxx_[p] += dt_ * (own_ * xx + other_ * yy), syy_[p] += dt_ * (other_ * xx + own_ * yy);
      sxy_[p] += dt_ * shear_ * xy;
    }
  }
  void map(std::size_t p) {
    const At here = at(p);
    const double v = volume_[p] * per_h_, xx = v * sxx_[p], yy = v * syy_[p], xy = v * sxy_[p];
    const double r = here.r, s = here.s;
    const std::array<double, 4> gx{s - 1, 1 - s, s, -s}, gy{r - 1, -r, r, 1 - r};
    for (std::size_t k = 0; k < 4; ++k) {
      Sums& sums = sums_[here.nodes[k]];
      const double m = here.N[k] * m_[p];
      sums.m += m, sums.px += m * vx_[p], sums.py += m * vy_[p];
      sums.fx -= gx[k] * xx + gy[k] * xy, sums.fy -= gx[k] * xy + gy[k] * yy;
    }
  }

  static constexpr double viscosity = 1e-3;
  double dt_, h_, per_h_, own_ = 0, other_ = 0, shear_ = 0, wave_ = 0;
  int nx_;
  std::vector<double> x_, y_, vx_, vy_, m_, volume_, e_, rho_, sxx_, syy_, sxy_;
  std::vector<Sums> sums_;
  std::vector<Motion> motion_;
  std::vector<Pair> convected_;
};

}  // namespace

int main(int argc, char** argv) { return plain::main_of<Thesis>(argc, argv); }
