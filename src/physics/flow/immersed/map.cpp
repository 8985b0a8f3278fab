// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/immersed/map.hpp"

#include <algorithm>

#include "physics/flow/elements.hpp"
#include "physics/flow/plane_elements.hpp"

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

class ExcessInertiaOfShape final : public ExcessInertia {
 public:
  explicit ExcessInertiaOfShape(const Solids& excess)
      : mesh_(excess.mesh), shape_(plane_shape(mesh_.kind)), nodes_(shape_.nodes), points_(shape_.mass_points.size()) {
    for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
      const double density = excess.regions[static_cast<std::size_t>(mesh_.region[e])].density;
      const PlaneVectors places = gathered(mesh_, e, mesh_.x);
      for (const PlanePoint& at : shape_.mass_points)
        masses_.push_back(density * plane_map(nodes_, places, at).determinant * at.weight);
    }
  }

  void add_forces(std::span<const double> x, std::span<const double> v, std::span<const double> rate,
                  std::span<double> f) const override {
    for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
      const PlaneVectors places = gathered(mesh_, e, x), velocities = gathered(mesh_, e, v);
      const PlaneVectors rates = gathered(mesh_, e, rate);
      for (std::size_t k = 0; k < points_; ++k) {
        const PlanePoint& at = shape_.mass_points[k];
        const PlaneVectors G = plane_map(nodes_, places, at).gradients;
        const Vec<2> carried = product(slopes(nodes_, velocities, G), mean(nodes_, at.N, velocities));
        const Vec<2> changed = mean(nodes_, at.N, rates);
        for (std::size_t a = 0; a < nodes_; ++a) {
          for (std::size_t i = 0; i < 2; ++i) f[2 * node(e, a) + i] += mass(e, k) * at.N[a] * (changed[i] + carried[i]);
        }
      }
    }
  }

  void add_tangent(std::span<const double> x, std::span<const double> v, double by_rate, double by_velocity,
                   const NodalPattern& pattern, SparseMatrix& S) const override {
    std::vector<double> m(4 * nodes_ * nodes_);
    for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
      const PlaneVectors places = gathered(mesh_, e, x), velocities = gathered(mesh_, e, v);
      std::ranges::fill(m, 0.0);
      for (std::size_t k = 0; k < points_; ++k) {
        const PlanePoint& at = shape_.mass_points[k];
        const PlaneVectors G = plane_map(nodes_, places, at).gradients;
        const PlaneMatrix L = slopes(nodes_, velocities, G);
        const Vec<2> u = mean(nodes_, at.N, velocities);
        for (std::size_t b = 0; b < nodes_; ++b) {
          const double along = by_rate * at.N[b] + by_velocity * dot(G[b], u), across = by_velocity * at.N[b];
          const PlaneMatrix by{
              {{along + across * L[0][0], across * L[0][1]}, {across * L[1][0], along + across * L[1][1]}}};
          add_column(mass(e, k), at.N, b, by, m);
        }
      }
      pattern.add(e, m, S);
    }
  }

 private:
  /// Adds the columns of node b, by whose velocity the acceleration has the derivative `by`.
  void add_column(double mass, const PlaneNumbers& N, std::size_t b, const PlaneMatrix& by,
                  std::vector<double>& m) const {
    for (std::size_t a = 0; a < nodes_; ++a) {
      for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t j = 0; j < 2; ++j) m[(2 * a + i) * 2 * nodes_ + 2 * b + j] += mass * N[a] * by[i][j];
      }
    }
  }
  std::size_t node(std::size_t e, std::size_t a) const { return static_cast<std::size_t>(mesh_.element(e)[a]); }
  double mass(std::size_t e, std::size_t k) const { return masses_[e * points_ + k]; }

  const Mesh& mesh_;
  const PlaneShape shape_;
  const std::size_t nodes_, points_;
  std::vector<double> masses_;
};

}  // namespace

std::unique_ptr<ExcessInertia> make_excess_inertia(const Solids& excess) {
  const bool none = std::all_of(excess.regions.begin(), excess.regions.end(),
                                [](const SolidRegion& region) { return region.density == 0; });
  if (none) return nullptr;
  return std::make_unique<ExcessInertiaOfShape>(excess);
}

}  // namespace tether::fem
