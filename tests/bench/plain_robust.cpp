// SPDX-License-Identifier: GPL-3.0-or-later
// The robust step as a plain loop: stress first, APIC, quadratic splines at nodes; arrays a property of the points, one
// record a node, points sorted by cells, one after the other. What points by lanes are measured against: no walls, one
// body, nothing booked and nothing checked.
#include <array>

#include "plain.hpp"

namespace {

struct Sums {
  double px, py, fx, fy, m, unused;  // with it pairs stand at even places, which is faster
};
struct Pair {
  double x, y;
};

/// Weights and slopes of the nodes before, at and behind a place along an axis.
struct Axis {
  std::array<double, 3> w, g;
  explicit Axis(double r)
      : w{0.5 * (0.5 - r) * (0.5 - r), 0.75 - r * r, 0.5 * (0.5 + r) * (0.5 + r)}, g{r - 0.5, -2 * r, r + 0.5} {}
};

template <bool gas>
class Robust {
 public:
  explicit Robust(const plain::Block& block)
      : dt_(block.dt()), h_(block.h()), per_h_(1 / block.h()), nx_(block.nodes()) {
    for (const plain::Point& p : points_of(block)) {
      x_.push_back(p.x), y_.push_back(p.y), vx_.push_back(p.vx), vy_.push_back(p.vy);
      vxx_.push_back(p.vxx), vyx_.push_back(p.vyx), vxy_.push_back(p.vxy), vyy_.push_back(p.vyy);
      m_.push_back(p.mass), volume_.push_back(p.mass);
    }
    e_.assign(x_.size(), 1);  // so cold that it keeps its place
    sxx_.assign(x_.size(), 0), syy_ = sxy_ = rho_ = sxx_;
    own_ = 1.35 * block.modulus(), other_ = 0.58 * block.modulus(), shear_ = 0.77 * block.modulus();
    const std::size_t nodes = static_cast<std::size_t>(nx_) * static_cast<std::size_t>(nx_);
    sums_.assign(nodes, Sums{}), old_.resize(nodes), new_.resize(nodes), density_.resize(nodes);
    for (std::size_t p = 0; p < x_.size(); ++p) map(p);
  }
  void step() {
    for (std::size_t n = 0; n < sums_.size(); ++n) {
      Sums& s = sums_[n];
      const double per_m = s.m > 0 ? 1 / s.m : 0;
      old_[n] = {s.px * per_m, s.py * per_m}, density_[n] = s.m * per_h_ * per_h_, s.fx = s.fy = 0;
    }
    for (std::size_t p = 0; p < x_.size(); ++p) pull(p);
    for (std::size_t n = 0; n < sums_.size(); ++n) {
      Sums& s = sums_[n];
      const double per_m = s.m > 0 ? 1 / s.m : 0;
      new_[n] = {old_[n].x + dt_ * s.fx * per_m, old_[n].y + dt_ * s.fy * per_m}, s.m = s.px = s.py = 0;
    }
    for (std::size_t p = 0; p < x_.size(); ++p) move(p);
  }
  double sum() const {
    double sum = wave_;
    for (std::size_t p = 0; p < x_.size(); ++p) sum += x_[p] + sxy_[p];
    return sum;
  }

 private:
  struct At {
    std::size_t node;
    double r, s;
    Axis x, y;
  };
  At at(std::size_t p) const {
    const double a = x_[p] * per_h_, b = y_[p] * per_h_;
    const int i = static_cast<int>(a + 0.5), j = static_cast<int>(b + 0.5);
    return {static_cast<std::size_t>((j - 1) * nx_ + i - 1), a - i, b - j, Axis(a - i), Axis(b - j)};
  }
  std::size_t row(const At& at, std::size_t l) const { return at.node + l * static_cast<std::size_t>(nx_); }

  /// grad v of a field of the nodes: d vx/dx, d vx/dy, d vy/dx, d vy/dy.
  template <class Velocity>
  std::array<double, 4> gradient(const At& at, const Velocity& velocity) const {
    std::array<double, 4> grad{};
    for (std::size_t l = 0; l < 3; ++l) {
      double gx = 0, wx = 0, gy = 0, wy = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Pair v = velocity(row(at, l) + k);
        gx += at.x.g[k] * v.x, wx += at.x.w[k] * v.x, gy += at.x.g[k] * v.y, wy += at.x.w[k] * v.y;
      }
      grad[0] += at.y.w[l] * gx, grad[1] += at.y.g[l] * wx, grad[2] += at.y.w[l] * gy, grad[3] += at.y.g[l] * wy;
    }
    for (double& g : grad) g *= per_h_;
    return grad;
  }
  void stress(std::size_t p, const At& at, const std::array<double, 4>& grad) {
    const double xx = grad[0], yy = grad[3], xy = 0.5 * (grad[1] + grad[2]);
    if constexpr (gas) {
      double rho = 0;
      for (std::size_t l = 0; l < 3; ++l) {
        double sum = 0;
        for (std::size_t k = 0; k < 3; ++k) sum += at.x.w[k] * density_[row(at, l) + k];
        rho += at.y.w[l] * sum;
      }
      rho_[p] = rho;
      const double rate = xx + yy, c = std::sqrt(0.56 * e_[p]);
      const double q = rate < 0 ? rho * (h_ * h_ * rate * rate - h_ * c * rate) : 0;
      const double mean = -0.4 * rho * e_[p] - q - viscosity * 2 / 3 * rate;
      sxx_[p] = mean + 2 * viscosity * xx, syy_[p] = mean + 2 * viscosity * yy, sxy_[p] = 2 * viscosity * xy;
      volume_[p] = m_[p] / rho;
    } else {
      sxx_[p] += dt_ * (own_ * xx + other_ * yy), syy_[p] += dt_ * (other_ * xx + own_ * yy);
      sxy_[p] += dt_ * shear_ * xy;
    }
  }
  void pull(std::size_t p) {
    const At here = at(p);
    stress(p, here, gradient(here, [this](std::size_t n) { return old_[n]; }));
    const double v = -volume_[p] * per_h_, xx = v * sxx_[p], yy = v * syy_[p], xy = v * sxy_[p];
    for (std::size_t l = 0; l < 3; ++l) {
      const double a = here.y.w[l] * xx, b = here.y.g[l] * xy, c = here.y.w[l] * xy, d = here.y.g[l] * yy;
      Sums* sums = &sums_[row(here, l)];
      for (std::size_t k = 0; k < 3; ++k) {
        sums[k].fx += here.x.g[k] * a + here.x.w[k] * b, sums[k].fy += here.x.g[k] * c + here.x.w[k] * d;
      }
    }
  }
  void move(std::size_t p) {
    const At here = at(p);
    if constexpr (gas) {
      const auto grad = gradient(here, [this](std::size_t n) {
        return Pair{0.5 * (old_[n].x + new_[n].x), 0.5 * (old_[n].y + new_[n].y)};
      });
      e_[p] += dt_ * (sxx_[p] * grad[0] + syy_[p] * grad[3] + sxy_[p] * (grad[1] + grad[2])) / rho_[p];
    }
    double vx = 0, vy = 0, xx = 0, yx = 0, xy = 0, yy = 0;
    for (std::size_t l = 0; l < 3; ++l) {
      double ux = 0, uy = 0, mx = 0, my = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Pair v = new_[row(here, l) + k];
        const double e = (static_cast<double>(k) - 1 - here.r) * here.x.w[k];
        ux += here.x.w[k] * v.x, uy += here.x.w[k] * v.y, mx += e * v.x, my += e * v.y;
      }
      ux *= here.y.w[l], uy *= here.y.w[l];
      const double e = static_cast<double>(l) - 1 - here.s;
      vx += ux, vy += uy, xx += here.y.w[l] * mx, yx += here.y.w[l] * my, xy += e * ux, yy += e * uy;
    }
    vx_[p] = vx, vy_[p] = vy, vxx_[p] = 4 * per_h_ * xx, vyx_[p] = 4 * per_h_ * yx, vxy_[p] = 4 * per_h_ * xy,
    vyy_[p] = 4 * per_h_ * yy;
    x_[p] += dt_ * vx, y_[p] += dt_ * vy;
    if constexpr (gas) wave_ = std::max(wave_, std::sqrt(0.56 * e_[p]) + std::sqrt(vx * vx + vy * vy));
    map(p);
  }
  void map(std::size_t p) {
    const At here = at(p);
    const double step_x = vxx_[p] * h_, step_y = vyx_[p] * h_;
    for (std::size_t l = 0; l < 3; ++l) {
      const double e = (static_cast<double>(l) - 1 - here.s) * h_, wy = here.y.w[l] * m_[p];
      double ux = vx_[p] - (1 + here.r) * step_x + e * vxy_[p], uy = vy_[p] - (1 + here.r) * step_y + e * vyy_[p];
      Sums* sums = &sums_[row(here, l)];
      for (std::size_t k = 0; k < 3; ++k) {
        const double w = wy * here.x.w[k];
        sums[k].m += w, sums[k].px += w * ux, sums[k].py += w * uy;
        ux += step_x, uy += step_y;
      }
    }
  }

  static constexpr double viscosity = 1e-3;
  double dt_, h_, per_h_, own_ = 0, other_ = 0, shear_ = 0, wave_ = 0;
  int nx_;
  std::vector<double> x_, y_, vx_, vy_, vxx_, vyx_, vxy_, vyy_, m_, volume_, e_, sxx_, syy_, sxy_, rho_;
  std::vector<Sums> sums_;
  std::vector<Pair> old_, new_;
  std::vector<double> density_;
};

}  // namespace

int main(int argc, char** argv) { return plain::main_of<Robust>(argc, argv); }
