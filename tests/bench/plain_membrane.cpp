// SPDX-License-Identifier: GPL-3.0-or-later
// The robust step of gas in a closed membrane, as a plain loop: the membrane's points pull along the pieces between
// them, and share the grid with the gas, whose density is of its own mass. PROGRAM gas [cells ...], see plain::Words.
#include "robust.hpp"

namespace {

constexpr plain::Features grid_features{.gas = true, .membranes = true}, gas_features{.gas = true};
using plain::Pair;
using Grid = plain::Nodes<grid_features>;

constexpr double radius = 0.45, points_a_cell = 4;  // of the membrane, along it

std::vector<plain::Point> gas(const plain::Block& block) {
  return plain::within(points_of(block), block, 0.5, 0.5, radius);
}
/// A quarter of a cell outside of the gas, a tenth of a cell thick.
std::vector<plain::Point> ring(const plain::Block& block) {
  const double r = radius + 0.25 * block.h(), turn = 2 * std::numbers::pi,
               middle = 0.5 + plain::Block::margin * block.h();
  const int count = static_cast<int>(turn * r / block.h() * points_a_cell);
  std::vector<plain::Point> points;
  for (int k = 0; k < count; ++k) {
    const double angle = turn * k / count;
    points.push_back({middle + r * std::cos(angle), middle + r * std::sin(angle), 0, 0, 0, 0, 0, 0,
                      turn * r / count * 0.1 * block.h()});
  }
  return points;
}

/// Pieces from each point to the next.
class Membrane {
 public:
  explicit Membrane(const plain::Block& block)
      : body_(block, ring(block)), modulus_(block.modulus()), force_(body_.size()), strain_(body_.size(), 0) {
    tx_ = ty_ = stress_ = energy_ = strain_;
    for (std::size_t p = 0; p < body_.size(); ++p) rest_.push_back(length(p, next(p)));
  }
  std::size_t size() const { return body_.size(); }
  void map(Grid& nodes) {
    for (std::size_t p = 0; p < size(); ++p) body_.map(p, nodes);
  }
  void pull(Grid& nodes) {
    std::fill(force_.begin(), force_.end(), Pair{});
    std::fill(strain_.begin(), strain_.end(), 0.0), std::fill(stress_.begin(), stress_.end(), 0.0);
    for (std::size_t p = 0; p < size(); ++p) pull_piece(p, next(p));
    for (std::size_t p = 0; p < size(); ++p) turn(p), spread(p, nodes);
  }
  void move(Grid& nodes) {
    for (std::size_t p = 0; p < size(); ++p) body_.move(p, nodes);
  }

 private:
  std::size_t next(std::size_t p) const { return p + 1 < size() ? p + 1 : 0; }
  double length(std::size_t a, std::size_t b) const {
    const double dx = body_.P.x[b] - body_.P.x[a], dy = body_.P.y[b] - body_.P.y[a];
    return std::sqrt(dx * dx + dy * dy);
  }
  /// The energy of a piece is V E ln(l/L)^2 / 2, compressed none; its force is the derivative.
  void pull_piece(std::size_t a, std::size_t b) {
    const double dx = body_.P.x[b] - body_.P.x[a], dy = body_.P.y[b] - body_.P.y[a], l = std::sqrt(dx * dx + dy * dy);
    const double strain = std::log(l / rest_[a]), stress = strain > 0 ? modulus_ * strain : 0;
    energy_[a] = 0.5 * body_.P.volume[a] * stress * strain;
    const double pull = body_.P.volume[a] * stress / (l * l);
    force_[a].x += pull * dx, force_[a].y += pull * dy, force_[b].x -= pull * dx, force_[b].y -= pull * dy;
    strain_[a] += 0.5 * strain, strain_[b] += 0.5 * strain, stress_[a] += 0.5 * stress, stress_[b] += 0.5 * stress;
  }
  /// The tangent at a point, and its stress in global axes.
  void turn(std::size_t p) {
    auto& P = body_.P;
    const std::size_t before = p > 0 ? p - 1 : size() - 1, after = next(p);
    const double l = length(before, after);
    tx_[p] = (P.x[after] - P.x[before]) / l, ty_[p] = (P.y[after] - P.y[before]) / l;
    P.sxx[p] = stress_[p] * tx_[p] * tx_[p], P.syy[p] = stress_[p] * ty_[p] * ty_[p];
    P.sxy[p] = stress_[p] * tx_[p] * ty_[p];
  }
  void spread(std::size_t p, Grid& nodes) {
    const plain::At here = body_.at(p, nodes);
    for (std::size_t l = 0; l < 3; ++l) {
      plain::Sums* sums = &nodes.sums[nodes.row(here, l)];
      for (std::size_t k = 0; k < 3; ++k) {
        const double N = here.x.w[k] * here.y.w[l];
        sums[k].fx += N * force_[p].x, sums[k].fy += N * force_[p].y;
      }
    }
  }

  plain::Body<plain::Features{}, grid_features> body_;
  double modulus_;
  std::vector<Pair> force_;
  std::vector<double> strain_, stress_, tx_, ty_, energy_, rest_;
};

class MembraneWithGas {
 public:
  explicit MembraneWithGas(const plain::Block& block) : nodes_(block), gas_(block, gas(block)), membrane_(block) {
    for (std::size_t p = 0; p < gas_.size(); ++p) gas_.map(p, nodes_);
    membrane_.map(nodes_);
  }
  std::size_t size() const { return gas_.size() + membrane_.size(); }
  void step() {
    nodes_.begin();
    for (std::size_t p = 0; p < gas_.size(); ++p) gas_.pull(p, gas_.at(p, nodes_), nodes_);
    membrane_.pull(nodes_);
    nodes_.solve(gas_.P.dt);
    for (std::size_t p = 0; p < gas_.size(); ++p) gas_.move(p, nodes_);
    membrane_.move(nodes_);
  }
  plain::Totals totals() const {
    plain::Totals totals;
    nodes_.add_to(totals);
    return totals;
  }

 private:
  Grid nodes_;
  plain::Body<gas_features, grid_features> gas_;
  Membrane membrane_;
};

}  // namespace

int main(int argc, char** argv) {
  const plain::Words words(argc, argv);
  return words.kind == "gas" ? plain::time_loop<MembraneWithGas>(words) : 2;
}
