// SPDX-License-Identifier: GPL-3.0-or-later
// The thesis' step as a plain loop: velocities mapped back before the stress, FLIP, bilinear functions; PROGRAM
// elastic|gas [cells ...], see plain::Words.
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
  explicit Thesis(const plain::Block& block) : P_(block, points_of(block)), per_h_(1 / block.h()), nx_(block.nodes()) {
    const std::size_t nodes = static_cast<std::size_t>(nx_) * static_cast<std::size_t>(nx_);
    sums_.assign(nodes, Sums{}), motion_.resize(nodes), convected_.resize(nodes);
    for (std::size_t p = 0; p < size(); ++p) map(p);
  }
  std::size_t size() const { return P_.size(); }
  void step() {
    for (std::size_t n = 0; n < sums_.size(); ++n) {
      const Sums& s = sums_[n];
      const double per_m = s.m > 0 ? 1 / s.m : 0, ax = s.fx * per_m, ay = s.fy * per_m;
      motion_[n] = {ax, ay, s.px * per_m + P_.dt * ax, s.py * per_m + P_.dt * ay};
      convected_[n] = {0, 0};
    }
    for (std::size_t p = 0; p < size(); ++p) accelerate(p);
    for (std::size_t n = 0; n < sums_.size(); ++n) {
      const double per_m = sums_[n].m > 0 ? 1 / sums_[n].m : 0;
      convected_[n].x *= per_m, convected_[n].y *= per_m;
      sums_[n] = {};
    }
    for (std::size_t p = 0; p < size(); ++p) strain_and_move(p), map(p);
  }
  plain::Totals totals() const {
    plain::Totals totals;
    for (const Sums& s : sums_)
      totals.mass += s.m, totals.px += s.px, totals.py += s.py, totals.scale += std::hypot(s.px, s.py);
    return totals;
  }

 private:
  struct At {
    std::array<std::size_t, 4> nodes;
    double r, s;
    std::array<double, 4> N;
  };
  At at(std::size_t p) const {
    const double a = P_.x[p] * per_h_, b = P_.y[p] * per_h_;
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
    P_.vx[p] += P_.dt * ax, P_.vy[p] += P_.dt * ay;
    const double px = P_.m[p] * P_.vx[p], py = P_.m[p] * P_.vy[p];
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
    P_.x[p] += P_.dt * ux, P_.y[p] += P_.dt * uy;
    const plain::Rates rates{xx, yy, 0.5 * (xy + yx), 0};
    if constexpr (gas) P_.rho[p] /= 1 + P_.dt * (xx + yy);
    P_.stress(p, rates);
    if constexpr (gas) P_.heat(p, rates), P_.note_wave(p);
  }
  void map(std::size_t p) {
    const At here = at(p);
    const double v = P_.volume[p] * per_h_, xx = v * P_.sxx[p], yy = v * P_.syy[p], xy = v * P_.sxy[p];
    const double r = here.r, s = here.s;
    const std::array<double, 4> gx{s - 1, 1 - s, s, -s}, gy{r - 1, -r, r, 1 - r};
    for (std::size_t k = 0; k < 4; ++k) {
      Sums& sums = sums_[here.nodes[k]];
      const double m = here.N[k] * P_.m[p];
      sums.m += m, sums.px += m * P_.vx[p], sums.py += m * P_.vy[p];
      sums.fx -= gx[k] * xx + gy[k] * xy, sums.fy -= gx[k] * xy + gy[k] * yy;
    }
  }

  plain::Points<plain::Features{.gas = gas}> P_;
  double per_h_;
  int nx_;
  std::vector<Sums> sums_;
  std::vector<Motion> motion_;
  std::vector<Pair> convected_;
};

}  // namespace

int main(int argc, char** argv) {
  const plain::Words words(argc, argv);
  if (words.kind == "elastic") return plain::time_loop<Thesis<false>>(words);
  if (words.kind == "gas") return plain::time_loop<Thesis<true>>(words);
  return 2;
}
