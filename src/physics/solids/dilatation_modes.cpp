// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solids/dilatation_modes.hpp"

#include <algorithm>
#include <cmath>

namespace tether::fem {

void DilatationModes::average(std::span<const double> values, std::span<double> mean) const {
  std::fill(mean.begin(), mean.end(), 0.0);
  for (std::size_t m = 0; m < count(); ++m) {
    double sum = 0;
    for (std::size_t k = 0; k < points(); ++k) sum += weights[k] * at(m, k) * values[k];
    for (std::size_t k = 0; k < points(); ++k) mean[k] += sum * at(m, k);
  }
}

/// Gram and Schmidt's way, from the constant on.
void add_dilatation_modes(std::span<const double> weights, std::span<const double> places, bool linear,
                          std::vector<double>& psi) {
  const std::size_t points = weights.size(), dim = places.size() / points, first = psi.size();
  const auto product = [&](const double* a, const double* b) {
    double sum = 0;
    for (std::size_t k = 0; k < points; ++k) sum += weights[k] * a[k] * b[k];
    return sum;
  };
  for (std::size_t m = 0; m < (linear ? dim + 1 : 1); ++m) {
    for (std::size_t k = 0; k < points; ++k) psi.push_back(m == 0 ? 1 : places[k * dim + m - 1]);
    double* own = &psi[first + m * points];
    for (int twice = 0; twice < 2; ++twice) {  // the second time takes what rounding left
      for (std::size_t n = 0; n < m; ++n) {
        const double* other = &psi[first + n * points];
        const double part = product(own, other);
        for (std::size_t k = 0; k < points; ++k) own[k] -= part * other[k];
      }
    }
    const double size = std::sqrt(product(own, own));
    for (std::size_t k = 0; k < points; ++k) own[k] /= size;
  }
}

}  // namespace tether::fem
