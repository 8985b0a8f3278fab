// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "physics/solids/elements_of_shape.hpp"

namespace tether::fem {

// Forces of elements and their tangents: what each iteration of a step asks for.

template <int dim>
auto ElementsOfShape<dim>::dilated_points(const Step& step, std::size_t e, bool with_modulus) const -> DilatedPoints {
  const Gradients F0 = deformations(gathered(e, step.q0), e), F1 = deformations(gathered(e, step.q1), e);
  DilatedPoints all;
  dilated_stresses<dim>(step.rule, law(e), std::span(F0).first(points_), std::span(F1).first(points_),
                        std::span(places_).subspan(e * points_, points_), modes_of(e), with_modulus,
                        std::span(all).first(points_));
  return all;
}

template <int dim>
void ElementsOfShape<dim>::find_forces(const Step& step, std::size_t e, std::span<double> f) const {
  std::ranges::fill(f, 0.0);
  const auto add = [&](std::size_t k, const PointStress<dim>& s) {
    const Square<dim> P = weight(e, k) * (s.A * full<dim>(s.S));
    const Vector* G = gradients(e, k);
    for (std::size_t a = 0; a < nodes_; ++a) Eigen::Map<Vector>(&f[a * dim]).noalias() += P * G[a];
  };
  if (is_dilated(e)) {
    const DilatedPoints all = dilated_points(step, e, false);
    for (std::size_t k = 0; k < points_; ++k) add(k, all[k].s);
  } else {
    const Vectors at0 = gathered(e, step.q0), at1 = gathered(e, step.q1);
    for (std::size_t k = 0; k < points_; ++k) add(k, stress<false>(step.rule, e, k, at0, at1));
  }
}

/// Calls compute(e, numbers) for each element, then add(e, numbers) in their order. The numbers, `count` of each
/// element, keep their place from one to the next, so that only the first ones of a call allocate.
template <int dim>
template <class Compute, class Add>
void ElementsOfShape<dim>::add_elements(std::size_t count, const Compute& compute, const Add& add) const {
  using Numbers = std::vector<double>;
  compute_then_add<Numbers>(
      team_, mesh_.element_count(),
      [&](std::size_t e, Numbers& own) {
        own.resize(count);
        compute(e, std::span(own));
      },
      [&](std::size_t e, const Numbers& own) { add(e, std::span(own)); });
}

template <int dim>
void ElementsOfShape<dim>::add_forces(StressAt at, std::span<const double> q0, std::span<const double> q1,
                                      std::span<double> f) const {
  add_elements(
      unknowns_,
      [&](std::size_t e, std::span<double> own) {
        find_forces({at, q0, q1}, e, own);
      },
      [&](std::size_t e, std::span<const double> own) {
        for (std::size_t a = 0; a < nodes_; ++a)
          Eigen::Map<Vector>(&f[node(e, a) * dim]) += Eigen::Map<const Vector>(&own[a * dim]);
      });
}

/// Adds w grad N_A . H . grad N_B for each pair of nodes.
template <int dim>
void ElementsOfShape<dim>::add_point_tangent(const GradientModulus<dim>& H, const Vector* G, double w,
                                             std::span<double> K) const {
  const std::size_t n = unknowns_;
  std::array<double, dim * dim * most_unknowns> by;  // P_ij, in row j dim + i, by the places of all nodes
  for (int ij = 0; ij < dim * dim; ++ij) {
    for (std::size_t b = 0; b < nodes_; ++b) {
      for (int m = 0; m < dim; ++m) {
        double sum = 0;
        for (int l = 0; l < dim; ++l) sum += H(ij, l * dim + m) * G[b][l];
        by[at(ij) * n + b * dim + at(m)] = sum;
      }
    }
  }
  for (std::size_t a = 0; a < nodes_; ++a) {
    const Vector g = w * G[a];
    for (std::size_t i = 0; i < dim; ++i) {
      double* row = &K[(a * dim + i) * n];
      for (std::size_t c = 0; c < n; ++c) {
        double sum = 0;
        for (int j = 0; j < dim; ++j) sum += g[j] * by[(at(j) * dim + i) * n + c];
        row[c] += sum;
      }
    }
  }
}

/// Sets K to the derivative of the forces by q1. Where `stresses` are given, they stand for those at q1 in what comes
/// of the shape's turning.
template <int dim>
void ElementsOfShape<dim>::find_tangent(const Step& step, std::size_t e, std::span<const double> stresses,
                                        std::span<double> K) const {
  std::ranges::fill(K, 0.0);
  const auto add = [&](std::size_t k, PointStress<dim> s) {
    if (!stresses.empty()) s.S = Eigen::Map<const Symmetric<dim>>(&stresses[(e * points_ + k) * parts]);
    add_point_tangent(gradient_modulus<dim>(s), gradients(e, k), weight(e, k), K);
  };
  if (is_dilated(e)) {
    const DilatedPoints all = dilated_points(step, e, true);
    for (std::size_t k = 0; k < points_; ++k) add(k, all[k].s);
    add_dilatation_tangent(e, all, K);
  } else {
    const Vectors at0 = gathered(e, step.q0), at1 = gathered(e, step.q1);
    for (std::size_t k = 0; k < points_; ++k) add(k, stress<true>(step.rule, e, k, at0, at1));
  }
}

/// Makes each of the law's own points convex for itself, and what the mean dilatation ties together as a whole.
template <int dim>
void ElementsOfShape<dim>::find_convex_tangent(std::span<const double> q, std::size_t e, std::span<double> K) const {
  if (is_dilated(e)) {
    find_tangent({StressAt::end, q, q}, e, {}, K);
    make_convex(static_cast<int>(unknowns_), K);
    return;
  }
  std::ranges::fill(K, 0.0);
  const Vectors at = gathered(e, q);
  for (std::size_t k = 0; k < points_; ++k) {
    const GradientModulus<dim> H = gradient_modulus<dim>(stress<true>(StressAt::end, e, k, at, at));
    add_point_tangent(convex<dim>(H), gradients(e, k), weight(e, k), K);
  }
}

template <int dim>
void ElementsOfShape<dim>::add_tangent(StressAt at, std::span<const double> q0, std::span<const double> q1,
                                       double inertia, const NodalPattern& pattern, SparseMatrix& K,
                                       std::span<const double> stresses) const {
  add_elements(
      unknowns_ * unknowns_,
      [&](std::size_t e, std::span<double> own) {
        find_tangent({at, q0, q1}, e, stresses, own);
        if (inertia != 0) add_inertia(e, inertia, own);
      },
      [&](std::size_t e, std::span<const double> own) { pattern.add(e, own, K); });
}

template <int dim>
void ElementsOfShape<dim>::add_stiffness(std::span<const double> q, bool convex, const NodalPattern& pattern,
                                         SparseMatrix& K) const {
  add_elements(
      unknowns_ * unknowns_,
      [&](std::size_t e, std::span<double> own) {
        if (convex) {
          find_convex_tangent(q, e, own);
        } else {
          find_tangent({StressAt::end, q, q}, e, {}, own);
        }
      },
      [&](std::size_t e, std::span<const double> own) { pattern.add(e, own, K); });
}

/// Sets the stresses at an element's points to what a change of places by `by` predicts.
template <int dim>
void ElementsOfShape<dim>::predict_points(const Step& step, std::size_t e, const Vectors& by,
                                          std::vector<double>& stresses) const {
  const auto predict = [&](std::size_t k, const PointStress<dim>& s) {
    const Vector* G = gradients(e, k);
    Symmetric<dim> strain = Symmetric<dim>::Zero();
    for (std::size_t a = 0; a < nodes_; ++a) strain += strain_map<dim>(s.F, G[a]) * by[a];
    at_point(stresses, e, k) = s.S + s.D * strain;
  };
  if (is_dilated(e)) {
    const DilatedPoints all = dilated_points(step, e, true);
    for (std::size_t k = 0; k < points_; ++k) predict(k, all[k].s);
    add_dilatation_to_stress(e, all, by, stresses);
  } else {
    const Vectors at0 = gathered(e, step.q0), at1 = gathered(e, step.q1);
    for (std::size_t k = 0; k < points_; ++k) predict(k, stress<true>(step.rule, e, k, at0, at1));
  }
}

template <int dim>
void ElementsOfShape<dim>::predict_stress(StressAt at, std::span<const double> q0, std::span<const double> q1,
                                          std::span<const double> change, std::vector<double>& stresses) const {
  stresses.resize(mesh_.element_count() * points_ * parts);
  team_.each(0, mesh_.element_count(), [&](std::size_t e) {
    predict_points({at, q0, q1}, e, gathered(e, change), stresses);
  });
}

}  // namespace tether::fem
