// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <utility>

#include "base/vec.hpp"
#include "loops/elements.hpp"
#include "physics/solids/elements.hpp"
#include "physics/solids/mean_dilatation.hpp"
#include "physics/solids/shape_table.hpp"
#include "physics/solids/stress_recovery.hpp"

namespace tether::fem {

/// Elements of one shape; the gradients of all points of quadrature are kept.
template <int dim>
class ElementsOfShape final : public Elements {
 public:
  ElementsOfShape(ShapeTable shape, const Solids& solids, Team& team)
      : shape_(std::move(shape)), team_(team), solids_(solids), mesh_(solids.mesh) {
    const std::size_t count = mesh_.element_count() * points_;
    gradients_.resize(count * nodes_);
    weights_.reserve(count);
    places_.reserve(count);
    for (const SolidRegion& region : solids.regions)
      dilated_.push_back(dilatation_of(solids.dilatation, mesh_.kind, region.law));
    for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
      for (std::size_t k = 0; k < points_; ++k) add_point(e, k);
      for (std::size_t k = 0; !one_rule_ && k < shape_.mass_points; ++k)
        mass_weights_.push_back(shape_.mass_weight(mesh_, e, static_cast<int>(k)));
      if (std::ranges::any_of(dilated_, &DilatationChoice::mean)) add_modes(e);
    }
  }

  void add_forces(StressAt at, std::span<const double> q0, std::span<const double> q1,
                  std::span<double> f) const override;
  void add_tangent(StressAt at, std::span<const double> q0, std::span<const double> q1, double inertia,
                   const NodalPattern& pattern, SparseMatrix& K, std::span<const double> stresses) const override;
  void add_stiffness(std::span<const double> q, bool convex, const NodalPattern& pattern,
                     SparseMatrix& K) const override;
  void predict_stress(StressAt at, std::span<const double> q0, std::span<const double> q1,
                      std::span<const double> change, std::vector<double>& stresses) const override;
  double strain_energy(std::span<const double> q) const override;
  std::vector<double> nodal_stress(std::span<const double> q) const override;
  SparseMatrix mass() const override;
  std::vector<double> lumped_volumes(int region) const override;
  std::vector<double> volumes(int region) const override;
  ShapeVolumes shape(std::span<const double> q) const override;
  double frequency_bound(std::span<const double> q, std::span<const double> lumped) const override;

 private:
  static constexpr std::size_t most = most_nodes<dim>, most_unknowns = dim * most;
  static constexpr std::size_t parts = component_count<dim>();  // of a symmetric tensor
  static constexpr std::size_t elements_of_a_block = 64;
  using Vector = Eigen::Matrix<double, dim, 1>;
  using Vectors = std::array<Vector, most>;         // of the nodes
  using Gradients = std::array<Square<dim>, most>;  // F at the points
  using Row = std::array<double, most_unknowns>;    // a number of each unknown
  using ModeRows = std::array<Row, std::size_t{dim + 1}>;
  using DilatedPoints = std::array<DilatedPoint<dim>, most>;
  using StressAtPoints = std::array<std::array<double, stress_fields>, most>;
  /// The shapes that a step goes between, and its rule.
  struct Step {
    StressAt rule;
    std::span<const double> q0, q1;
  };

  void add_point(std::size_t e, std::size_t k) {
    Vector& first = gradients_[(e * points_ + k) * nodes_];
    weights_.push_back(shape_.weight(mesh_, e, static_cast<int>(k), first.data()));
    const Vector place = place_of(gathered(e, mesh_.x), &shape_.values[k * nodes_]);
    places_.push_back({place[0], place[1]});
  }
  void add_modes(std::size_t e) {
    const Vectors at = gathered(e, mesh_.x);
    Vectors places;
    for (std::size_t k = 0; k < points_; ++k) places[k] = place_of(at, &shape_.values[k * nodes_]);
    add_dilatation_modes(std::span(weights_).last(points_), std::span(places[0].data(), dim * points_), mode_count_ > 1,
                         modes_);
  }
  DilatationModes modes_of(std::size_t e) const {
    return {std::span(weights_).subspan(e * points_, points_),
            std::span(modes_).subspan(e * points_ * mode_count_, points_ * mode_count_), stabiliser(e)};
  }
  bool is_dilated(std::size_t e) const { return dilated_[at(mesh_.region[e])].mean; }
  double stabiliser(std::size_t e) const { return dilated_[at(mesh_.region[e])].stabiliser; }

  const ElasticLaw& law(std::size_t e) const { return solids_.regions[at(mesh_.region[e])].law; }
  double density(std::size_t e) const { return solids_.regions[at(mesh_.region[e])].density; }
  std::size_t node(std::size_t e, std::size_t a) const { return at(mesh_.nodes[e * nodes_ + a]); }
  const Vector* gradients(std::size_t e, std::size_t k) const { return &gradients_[(e * points_ + k) * nodes_]; }
  double weight(std::size_t e, std::size_t k) const { return weights_[e * points_ + k]; }
  double mass_weight(std::size_t e, std::size_t k) const {
    return one_rule_ ? weight(e, k) : mass_weights_[e * shape_.mass_points + k];
  }
  const Vec<2>& place(std::size_t e, std::size_t k) const { return places_[e * points_ + k]; }

  Vectors gathered(std::size_t e, std::span<const double> q) const {
    Vectors at;
    for (std::size_t a = 0; a < nodes_; ++a) at[a] = Eigen::Map<const Vector>(&q[node(e, a) * dim]);
    return at;
  }
  Vector place_of(const Vectors& at, const double* values) const {
    Vector x = Vector::Zero();
    for (std::size_t a = 0; a < nodes_; ++a) x += values[a] * at[a];
    return x;
  }
  Square<dim> deformation(const Vectors& at, std::size_t e, std::size_t k) const {
    const Vector* G = gradients(e, k);
    Square<dim> F = Square<dim>::Zero();
    for (std::size_t a = 0; a < nodes_; ++a) F.noalias() += at[a] * G[a].transpose();
    return F;
  }
  Gradients deformations(const Vectors& at, std::size_t e) const {
    Gradients F;
    for (std::size_t k = 0; k < points_; ++k) F[k] = deformation(at, e, k);
    return F;
  }
  /// What the law takes for F at the points, and what is left out of the dilatation.
  struct SeenByLaw {
    Gradients F;
    std::array<double, most> left_out{};
  };
  SeenByLaw seen_by_law(const Vectors& at, std::size_t e) const {
    SeenByLaw seen{deformations(at, e)};
    if (is_dilated(e))
      take_mean_dilatation<dim>(law(e), modes_of(e), std::span(seen.F).first(points_),
                                std::span(seen.left_out).first(points_));
    return seen;
  }
  double least_mean_dilatation(const Vectors& at, std::size_t e) const;

  template <bool with_modulus>
  PointStress<dim> stress(StressAt rule, std::size_t e, std::size_t k, const Vectors& at0, const Vectors& at1) const {
    return point_stress<dim, with_modulus>(rule, law(e), deformation(at0, e, k), deformation(at1, e, k), place(e, k)[0],
                                           place(e, k)[1]);
  }
  /// The stresses at all points of an element whose law sees the mean dilatation, and how they change with it.
  DilatedPoints dilated_points(const Step& step, std::size_t e, bool with_modulus) const;

  template <class Compute, class Add>
  void add_elements(std::size_t count, const Compute& compute, const Add& add) const;
  void find_forces(const Step& step, std::size_t e, std::span<double> f) const;
  void find_tangent(const Step& step, std::size_t e, std::span<const double> stresses, std::span<double> K) const;
  void find_convex_tangent(std::span<const double> q, std::size_t e, std::span<double> K) const;
  void add_point_tangent(const GradientModulus<dim>& H, const Vector* G, double w, std::span<double> K) const;
  void predict_points(const Step& step, std::size_t e, const Vectors& by, std::vector<double>& stresses) const;
  Eigen::Map<Symmetric<dim>> at_point(std::vector<double>& stresses, std::size_t e, std::size_t k) const {
    return Eigen::Map<Symmetric<dim>>(&stresses[(e * points_ + k) * parts]);
  }

  void by_places(const Square<dim>& F, const Symmetric<dim>& by_strain, const Vector* G, Row& row) const;
  template <class AtPoint>
  ModeRows mode_rows(std::size_t e, const AtPoint& at_point) const;
  void add_dilatation_tangent(std::size_t e, const DilatedPoints& at, std::span<double> K) const;
  void add_dilatation_to_stress(std::size_t e, const DilatedPoints& at, const Vectors& by,
                                std::vector<double>& stresses) const;

  void find_mass(std::size_t e, std::span<double> m) const;
  void add_inertia(std::size_t e, double inertia, std::span<double> K) const;

  std::array<double, stress_fields> cauchy_stress(std::size_t e, std::size_t k, const Square<dim>& F) const;
  StressAtPoints stress_at_points(std::size_t e, const Vectors& places) const;
  std::array<double, stress_fields> stress_at_node(std::size_t a, const StressAtPoints& there) const;
  void add_samples(std::size_t e, const StressAtPoints& there, StressSamples& samples) const;

  const ShapeTable shape_;
  const std::size_t nodes_ = shape_.nodes, points_ = shape_.points, unknowns_ = dim * nodes_;
  const bool one_rule_ = shape_.mass_points == points_;  // which is that of gradients for masses, too
  /// Functions that the mean dilatation is made of: a number an element; of order 2 in a product of lines, of degree 1.
  const std::size_t mode_count_ = shape_.order == 2 && !shape_.is_simplex ? dim + 1 : 1;
  Team& team_;
  const Solids& solids_;
  const Mesh& mesh_;
  std::vector<Vector> gradients_;
  std::vector<double> weights_, mass_weights_, modes_;
  std::vector<DilatationChoice> dilated_;  // of each region
  std::vector<Vec<2>> places_;
};

}  // namespace tether::fem
