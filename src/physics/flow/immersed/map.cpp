// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/immersed/map.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>

#include "grid/shapes.hpp"
#include "physics/flow/elements.hpp"

namespace tether::fem {

ImmersedMap::ImmersedMap(const Flow& flow) : flow_(flow), finder_(flow.mesh), count_(node_count_of(flow.mesh.kind)) {}

std::optional<std::size_t> ImmersedMap::place(std::span<const double> x) {
  const std::size_t nodes = x.size() / 2;
  element_.resize(nodes, -1), cell_.resize(nodes), parts_.resize(nodes * size());
  for (std::size_t n = 0; n < nodes; ++n) {
    const auto found = finder_.find({x[2 * n], x[2 * n + 1]}, element_[n]);
    if (!found) return n;
    element_[n] = found->element;
    const auto write = [&](const auto& values) { std::copy(values.begin(), values.end(), &parts_[n * size()]); };
    with_values_at(flow_.mesh.kind, found->s, write);
  }
  cells_ = element_;
  std::sort(cells_.begin(), cells_.end());
  cells_.erase(std::unique(cells_.begin(), cells_.end()), cells_.end());
  nodes_.clear();
  for (const int cell : cells_) {
    for (int a = 0; a < count_; ++a)
      nodes_.push_back(flow_.twin[static_cast<std::size_t>(flow_.mesh.element(static_cast<std::size_t>(cell))[a])]);
  }
  for (std::size_t n = 0; n < nodes; ++n)
    cell_[n] = static_cast<std::size_t>(std::lower_bound(cells_.begin(), cells_.end(), element_[n]) - cells_.begin());
  return std::nullopt;
}

void ImmersedMap::velocities(std::span<const double> v, std::span<double> V) const {
  for (std::size_t n = 0; n < cell_.size(); ++n) {
    double x = 0, y = 0;
    for (std::size_t a = 0; a < size(); ++a) {
      const auto node = static_cast<std::size_t>(nodes_[cell_[n] * size() + a]);
      x += parts_[n * size() + a] * v[2 * node], y += parts_[n * size() + a] * v[2 * node + 1];
    }
    V[2 * n] = x, V[2 * n + 1] = y;
  }
}

void ImmersedMap::add_forces(std::span<const double> F, std::span<double> f) const {
  for (std::size_t n = 0; n < cell_.size(); ++n) {
    for (std::size_t a = 0; a < size(); ++a) {
      const auto node = static_cast<std::size_t>(nodes_[cell_[n] * size() + a]);
      f[2 * node] += parts_[n * size() + a] * F[2 * n], f[2 * node + 1] += parts_[n * size() + a] * F[2 * n + 1];
    }
  }
}

namespace {

template <class Shapes>
class ExcessInertiaOf final : public ExcessInertia {
 public:
  static constexpr int nodes = Shapes::nodes, points = Shapes::mass_points, size = 2 * nodes;
  using Values = Eigen::Matrix<double, nodes, 1>;
  using Columns = Eigen::Matrix<double, 2, nodes>;

  explicit ExcessInertiaOf(const Solids& excess) : mesh_(excess.mesh) {
    for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
      const double density = excess.regions[static_cast<std::size_t>(mesh_.region[e])].density;
      for (int k = 0; k < points; ++k) {
        const auto map = jacobian_at<Shapes>(mesh_, e, Shapes::mass_place(k));
        gradients_.push_back(Eigen::Map<const Columns>(map.gradients.data()));
        masses_.push_back(density * map.determinant * Shapes::mass_weight(k));
      }
    }
    for (int k = 0; k < points; ++k)
      values_[static_cast<std::size_t>(k)] = Eigen::Map<const Values>(Shapes::values(Shapes::mass_place(k)).data());
  }

  void add_forces(std::span<const double> x, std::span<const double> v, std::span<const double> rate,
                  std::span<double> f) const override {
    for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
      const Columns at = gathered(e, x), velocities = gathered(e, v), rates = gathered(e, rate);
      Columns sum = Columns::Zero();
      for (int k = 0; k < points; ++k) {
        const Values& N = values_[static_cast<std::size_t>(k)];
        const Eigen::Vector2d u = velocities * N;
        const Eigen::Vector2d force = rates * N + velocities * (slopes(at, e, k).transpose() * u);
        sum += mass(e, k) * force * N.transpose();
      }
      for (int a = 0; a < nodes; ++a) Eigen::Map<Eigen::Vector2d>(&f[2 * node(e, a)]) += sum.col(a);
    }
  }

  void add_tangent(std::span<const double> x, std::span<const double> v, double by_rate, double by_velocity,
                   const NodalPattern& pattern, SparseMatrix& S) const override {
    for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
      const Columns at = gathered(e, x), velocities = gathered(e, v);
      Eigen::Matrix<double, size, size, Eigen::RowMajor> m = Eigen::Matrix<double, size, size>::Zero();
      for (int k = 0; k < points; ++k) {
        const Values& N = values_[static_cast<std::size_t>(k)];
        const Columns G = slopes(at, e, k);
        const Eigen::Matrix2d L = velocities * G.transpose();
        const Values carried = G.transpose() * (velocities * N);
        for (int a = 0; a < nodes; ++a) {
          for (int b = 0; b < nodes; ++b) {
            Eigen::Matrix2d by = by_velocity * N[b] * L;
            by.diagonal().array() += by_rate * N[b] + by_velocity * carried[b];
            m.template block<2, 2>(2 * a, 2 * b) += mass(e, k) * N[a] * by;
          }
        }
      }
      pattern.add(e, std::span(m.data(), static_cast<std::size_t>(m.size())), S);
    }
  }

 private:
  std::size_t node(std::size_t e, int a) const { return static_cast<std::size_t>(mesh_.element(e)[a]); }
  double mass(std::size_t e, int k) const { return masses_[e * points + static_cast<std::size_t>(k)]; }
  Columns gathered(std::size_t e, std::span<const double> q) const {
    Columns at;
    for (int a = 0; a < nodes; ++a) at.col(a) = Eigen::Map<const Eigen::Vector2d>(&q[2 * node(e, a)]);
    return at;
  }
  /// Gradients of the functions in the shape whose nodes are at `at`: F^-T grad_X N.
  Columns slopes(const Columns& at, std::size_t e, int k) const {
    const Columns& G = gradients_[e * points + static_cast<std::size_t>(k)];
    const Eigen::Matrix2d F = at * G.transpose();
    return F.inverse().transpose() * G;
  }

  const Mesh& mesh_;
  std::array<Values, static_cast<std::size_t>(points)> values_;
  std::vector<Columns> gradients_;
  std::vector<double> masses_;
};

}  // namespace

std::unique_ptr<ExcessInertia> make_excess_inertia(const Solids& excess) {
  const bool none = std::all_of(excess.regions.begin(), excess.regions.end(),
                                [](const SolidRegion& region) { return region.density == 0; });
  if (none) return nullptr;
  return with_shapes<2>(excess.mesh.kind, [&](auto shapes) -> std::unique_ptr<ExcessInertia> {
    return std::make_unique<ExcessInertiaOf<decltype(shapes)>>(excess);
  });
}

}  // namespace tether::fem
