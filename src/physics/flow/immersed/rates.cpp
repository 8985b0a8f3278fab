// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/immersed/rates.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>

#include "grid/shapes.hpp"

namespace tether::fem {
namespace {

template <class Shapes>
using Columns = Eigen::Matrix<double, 2, Shapes::nodes>;

template <class Shapes>
Columns<Shapes> gathered(const Mesh& mesh, std::size_t e, std::span<const double> q) {
  Columns<Shapes> at;
  for (int a = 0; a < Shapes::nodes; ++a)
    at.col(a) = Eigen::Map<const Eigen::Vector2d>(&q[2 * static_cast<std::size_t>(mesh.element(e)[a])]);
  return at;
}

/// Of an element at a point of quadrature: values of its functions, place, dv/dt, and the volume at the start.
template <class Shapes>
struct PointRate {
  Eigen::Matrix<double, Shapes::nodes, 1> N;
  Eigen::Vector2d place, acceleration;
  double weight = 0;
};

/// Calls f with each of them.
template <class Shapes, class Function>
void for_points(const Mesh& mesh, std::size_t e, const BodyMotion& motion, const Function& f) {
  const auto places = gathered<Shapes>(mesh, e, motion.places),
             velocities = gathered<Shapes>(mesh, e, motion.velocities);
  const auto rates = gathered<Shapes>(mesh, e, motion.rates);
  for (int k = 0; k < Shapes::mass_points; ++k) {
    const auto s = Shapes::mass_place(k);
    const auto map = jacobian_at<Shapes>(mesh, e, s);
    const Eigen::Map<const Columns<Shapes>> G(map.gradients.data());
    PointRate<Shapes> at;
    at.N = Eigen::Map<const Eigen::Matrix<double, Shapes::nodes, 1>>(Shapes::values(s).data());
    const Eigen::Matrix2d F = places * G.transpose();
    const Eigen::Matrix2d slopes = velocities * (F.inverse().transpose() * G).transpose();
    at.place = places * at.N, at.acceleration = rates * at.N + slopes * (velocities * at.N);
    at.weight = map.determinant * Shapes::mass_weight(k);
    f(at);
  }
}

/// <grad N_A, sigma> of element e, whose first point of quadrature is the first of these stresses.
template <class Shapes>
void add_stress(const Mesh& mesh, std::size_t e, std::span<const double> x, const std::array<double, 3>* stress,
                std::span<double> f) {
  const auto places = gathered<Shapes>(mesh, e, x);
  for (int k = 0; k < Shapes::points; ++k) {
    const auto gradients = Shapes::gradients(Shapes::place(k));
    const Eigen::Map<const Columns<Shapes>> S(gradients.data());
    const Eigen::Matrix2d J = places * S.transpose();
    const Columns<Shapes> G = J.inverse().transpose() * S;
    const auto& [xx, yy, xy] = stress[k];
    const double volume = J.determinant() * Shapes::weight(k);
    for (int a = 0; a < Shapes::nodes; ++a) {
      double* to = &f[2 * static_cast<std::size_t>(mesh.element(e)[a])];
      to[0] += volume * (xx * G(0, a) + xy * G(1, a)), to[1] += volume * (xy * G(0, a) + yy * G(1, a));
    }
  }
}

}  // namespace

std::vector<BodyRates> body_rates(const Mesh& mesh, const BodyMotion& motion) {
  std::vector<BodyRates> bodies(static_cast<std::size_t>(1 + *std::ranges::max_element(mesh.region)));
  with_shapes<2>(mesh.kind, [&]<class Shapes>(const Shapes&) {
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      BodyRates& body = bodies[static_cast<std::size_t>(mesh.region[e])];
      for_points<Shapes>(mesh, e, motion, [&](const PointRate<Shapes>& at) {
        body.volume += at.weight;
        for (std::size_t i = 0; i < 2; ++i) {
          body.centre[i] += at.weight * at.place[static_cast<int>(i)];
          body.acceleration[i] += at.weight * at.acceleration[static_cast<int>(i)];
        }
      });
    }
  });
  for (BodyRates& body : bodies) {
    for (double& number : body.centre) number /= body.volume;
  }
  return bodies;
}

void add_body_inertia(const Mesh& mesh, const BodyMotion& motion, int region, double density, double gravity,
                      std::span<double> f) {
  with_shapes<2>(mesh.kind, [&]<class Shapes>(const Shapes&) {
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      if (mesh.region[e] != region) continue;
      for_points<Shapes>(mesh, e, motion, [&](const PointRate<Shapes>& at) {
        const double mass = density * at.weight;
        for (int a = 0; a < Shapes::nodes; ++a) {
          double* to = &f[2 * static_cast<std::size_t>(mesh.element(e)[a])];
          to[0] += mass * at.N[a] * at.acceleration[0], to[1] += mass * at.N[a] * (at.acceleration[1] - gravity);
        }
      });
    }
  });
}

std::vector<Vec<2>> body_points(const Mesh& mesh, std::span<const double> x) {
  std::vector<Vec<2>> points;
  with_shapes<2>(mesh.kind, [&]<class Shapes>(const Shapes&) {
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      const auto places = gathered<Shapes>(mesh, e, x);
      for (int k = 0; k < Shapes::points; ++k) {
        const auto values = Shapes::values(Shapes::place(k));
        const Eigen::Vector2d at = places * Eigen::Map<const Eigen::Matrix<double, Shapes::nodes, 1>>(values.data());
        points.push_back({at[0], at[1]});
      }
    }
  });
  return points;
}

void add_body_stress(const Mesh& mesh, std::span<const double> x, int region,
                     std::span<const std::array<double, 3>> stress, std::span<double> f) {
  with_shapes<2>(mesh.kind, [&]<class Shapes>(const Shapes&) {
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      if (mesh.region[e] == region) add_stress<Shapes>(mesh, e, x, &stress[e * std::size_t{Shapes::points}], f);
    }
  });
}

}  // namespace tether::fem
