// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tether::fem {

/// The functions of place that J is the mean by: orthonormal over an element, sum_k w_k psi_m(k) psi_n(k) = delta_mn,
/// so that Pi_kl = sum_m psi_m(k) psi_m(l) w_l.
struct DilatationModes {
  std::span<const double> weights;  ///< of the points of quadrature [volume]
  std::span<const double> psi;      ///< of all points the first, of all points the second, ...
  double stabiliser = 0;            ///< c [stress]

  std::size_t points() const { return weights.size(); }
  std::size_t count() const { return psi.size() / weights.size(); }
  double at(std::size_t mode, std::size_t point) const { return psi[mode * points() + point]; }
  /// The mean of values at the points, at the points.
  void average(std::span<const double> values, std::span<double> mean) const;
};

/// Appends the modes of an element with points of these weights at these places, dim numbers each: a constant and, with
/// `linear`, functions of degree 1.
void add_dilatation_modes(std::span<const double> weights, std::span<const double> places, bool linear,
                          std::vector<double>& psi);

}  // namespace tether::fem
