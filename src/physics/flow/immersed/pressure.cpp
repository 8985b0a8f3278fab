// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/immersed/pressure.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "grid/shapes.hpp"
#include "physics/flow/unknowns.hpp"

namespace tether::fem {
namespace {

/// eps: the part of a cell's own exchange between pressure and flux that bodies let through. Large, fluid goes through
/// the body; of a plate of two cells across a channel 0.5, 0.05, 0.005, 0.0005 change the load by -15, -7, -3, -2.4 %.
constexpr double extension_part = 0.005;

/// Of the pressure in a sudden step: enough for the pressure in a closed box to have a level.
constexpr double taken_out_suddenly = 1e-6;

using Quad4 = ShapesOf<ElementKind::quad4>;

}  // namespace

ImmersedPressure::ImmersedPressure(const Flow& flow, const Solids& solids, double gravity)
    : flow_(flow), solids_(solids), gravity_(gravity), finder_(flow.mesh) {
  const Mesh& mesh = solids.mesh;
  with_shapes(mesh.kind, [&](auto shapes) {
    using Shapes = decltype(shapes);
    points_ = static_cast<std::size_t>(Shapes::points);
    if constexpr (Shapes::dim == 2) {
      for (int k = 0; k < Shapes::points; ++k) {
        const auto N = Shapes::values(Shapes::place(k));
        values_.insert(values_.end(), N.begin(), N.end());
      }
      for (std::size_t e = 0; e < mesh.element_count(); ++e) {
        for (int k = 0; k < Shapes::points; ++k) {
          const auto map = jacobian_at<Shapes>(mesh, e, Shapes::place(k));
          gradients_.insert(gradients_.end(), map.gradients.begin(), map.gradients.end());
          weights_.push_back(map.determinant * Shapes::weight(k));
        }
      }
    }
  });
  below_.assign(weights_.size(), -1);
}

void ImmersedPressure::place(std::span<const double> x, const PressureStep& step) {
  step_ = step, growth_ = 0;
  at_.clear(), slopes_.clear();
  for (std::size_t e = 0; e < solids_.mesh.element_count(); ++e) {
    if (flow_.volume_by_fluid[at(solids_.mesh.region[e])]) continue;
    for (std::size_t k = 0; k < points_; ++k) add_point(x, e, k);
  }
  number_elements();
  sum_extension();
}

void ImmersedPressure::restore_volume(double time) {
  double volume = 0, reference = 0;
  for (const Point& point : at_) volume += point.volume, reference += point.reference;
  if (volume > 0) growth_ = (reference - volume) / (volume * time);
}

/// A point off the fluid's mesh, as a body's curved edge has some beyond a wall, has no pressure.
void ImmersedPressure::add_point(std::span<const double> x, std::size_t e, std::size_t k) {
  const int* element = solids_.mesh.element(e);
  const double* G = &gradients_[2 * nodes() * (points_ * e + k)];
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  Eigen::Matrix2d F = Eigen::Matrix2d::Zero();
  for (std::size_t a = 0; a < nodes(); ++a) {
    const Eigen::Map<const Eigen::Vector2d> node(&x[2 * at(element[a])]);
    place += values_[nodes() * k + a] * node;
    F += node * Eigen::Map<const Eigen::RowVector2d>(&G[2 * a]);
  }
  int& below = below_[points_ * e + k];
  const auto found = finder_.find({place[0], place[1]}, below);
  if (!found) return;
  below = found->element;
  Point point{.element = e,
              .of_fluid = at(found->element),
              .volume = (step_.sudden ? taken_out_suddenly : 1) * F.determinant() * weights_[points_ * e + k],
              .reference = weights_[points_ * e + k]};
  double area = 0;
  set_pressure(point, *found, area);
  point.tau = extension_part / std::hypot(step_.viscosity / area, flow_.density * step_.rate);
  const auto b = flow_.acceleration.absent() ? Vec<2>{} : flow_.acceleration.at(place[0], place[1], step_.time);
  point.source = {step_.loaded * flow_.density * b[0], step_.loaded * flow_.density * (b[1] + gravity_)};
  at_.push_back(point);
  const Eigen::Matrix2d to_present = F.inverse().transpose();
  for (std::size_t a = 0; a < nodes(); ++a) {
    const Eigen::Vector2d slope = to_present * Eigen::Map<const Eigen::Vector2d>(&G[2 * a]);
    slopes_.push_back(slope[0]), slopes_.push_back(slope[1]);
  }
}

/// The pressure's functions there, and the size of the fluid's element [length2].
void ImmersedPressure::set_pressure(Point& point, const PointFinder::Found& found, double& area) const {
  const Mesh& mesh = flow_.mesh;
  const int* element = mesh.element(at(found.element));
  Eigen::Matrix2d J = Eigen::Matrix2d::Zero();
  with_shapes(mesh.kind, [&](auto shapes) {
    using Shapes = decltype(shapes);
    if constexpr (Shapes::dim == 2) {
      const auto S = Shapes::gradients(found.s);
      for (std::size_t a = 0; a < static_cast<std::size_t>(Shapes::nodes); ++a) {
        J += Eigen::Map<const Eigen::Vector2d>(&mesh.x[2 * at(element[a])]) *
             Eigen::Map<const Eigen::RowVector2d>(&S[2 * a]);
      }
    }
  });
  area = 4 * std::abs(J.determinant());
  const Eigen::Matrix2d inverse = J.inverse();
  point.q = Quad4::values(found.s);
  const auto S = Quad4::gradients(found.s);
  for (std::size_t c = 0; c < 4; ++c)
    Eigen::Map<Eigen::RowVector2d>(&point.slope[2 * c]) = Eigen::Map<const Eigen::RowVector2d>(&S[2 * c]) * inverse;
}

void ImmersedPressure::number_elements() {
  elements_.clear();
  for (const Point& point : at_) elements_.push_back(static_cast<int>(point.of_fluid));
  std::ranges::sort(elements_);
  elements_.erase(std::unique(elements_.begin(), elements_.end()), elements_.end());
  for (Point& point : at_) {
    const auto found = std::ranges::lower_bound(elements_, static_cast<int>(point.of_fluid));
    point.of_fluid = static_cast<std::size_t>(found - elements_.begin());
  }
}

void ImmersedPressure::sum_extension() {
  extension_.assign(16 * elements_.size(), 0.0);
  for (const Point& point : at_) {
    const Eigen::Map<const Eigen::Matrix<double, 2, 4>> slope(point.slope.data());
    Eigen::Map<Eigen::Matrix4d>(&extension_[16 * point.of_fluid]) +=
        point.volume * point.tau * slope.transpose() * slope;
  }
}

int ImmersedPressure::pressure_node(std::size_t of_fluid, std::size_t corner) const {
  const int node = flow_.mesh.element(at(elements_[of_fluid]))[pressure_nodes(flow_.element)[corner]];
  return flow_.twin[at(node)];
}

void ImmersedPressure::add_forces(std::span<const double> p, std::span<double> F) const {
  for (std::size_t n = 0; n < at_.size(); ++n) {
    const Point& point = at_[n];
    double pressure = 0;
    for (std::size_t c = 0; c < 4; ++c) pressure += point.q[c] * p[at(pressure_node(point.of_fluid, c))];
    const int* element = solids_.mesh.element(point.element);
    for (std::size_t a = 0; a < nodes(); ++a) {
      for (std::size_t i = 0; i < 2; ++i)
        F[2 * at(element[a]) + i] += point.volume * pressure * slopes_at(n)[2 * a + i];
    }
  }
}

double ImmersedPressure::add_fluxes(std::span<const double> V, std::span<const double> p, std::span<double> g) const {
  double size = 0;
  for (std::size_t n = 0; n < at_.size(); ++n) {
    const Point& point = at_[n];
    const int* element = solids_.mesh.element(point.element);
    double divergence = -growth_;
    for (std::size_t a = 0; a < nodes(); ++a) {
      for (std::size_t i = 0; i < 2; ++i) divergence += slopes_at(n)[2 * a + i] * V[2 * at(element[a]) + i];
    }
    Eigen::Vector2d rest(-point.source[0], -point.source[1]);  // grad p - rho b
    double part = rest.norm();
    for (std::size_t c = 0; c < 4; ++c) {
      const Eigen::Vector2d slope(point.slope[2 * c], point.slope[2 * c + 1]);
      const double pressure = p[at(pressure_node(point.of_fluid, c))];
      rest += pressure * slope, part += std::abs(pressure) * slope.norm();
    }
    for (std::size_t c = 0; c < 4; ++c) {
      const Eigen::Vector2d slope(point.slope[2 * c], point.slope[2 * c + 1]);
      const double extended = point.tau * rest.dot(slope);
      g[at(pressure_node(point.of_fluid, c))] += point.volume * (extended - point.q[c] * divergence);
      size += std::pow(point.volume * point.tau * part * slope.norm(), 2);
    }
  }
  return std::sqrt(size);
}

EigenSparse ImmersedPressure::divergence() const {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t n = 0; n < at_.size(); ++n) {
    const Point& point = at_[n];
    const int* element = solids_.mesh.element(point.element);
    for (std::size_t a = 0; a < nodes(); ++a) {
      for (int i = 0; i < 2; ++i) {
        for (std::size_t c = 0; c < 4; ++c)
          entries.emplace_back(static_cast<int>(4 * point.of_fluid + c), 2 * element[a] + i,
                               point.volume * point.q[c] * slopes_at(n)[2 * a + static_cast<std::size_t>(i)]);
      }
    }
  }
  EigenSparse D(static_cast<Eigen::Index>(4 * elements_.size()), static_cast<Eigen::Index>(solids_.mesh.x.size()));
  D.setFromTriplets(entries.begin(), entries.end());
  return D;
}

}  // namespace tether::fem
