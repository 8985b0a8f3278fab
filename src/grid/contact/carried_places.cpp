// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/contact/carried_places.hpp"

#include <cmath>

#include "base/numbers.hpp"

namespace tether {

std::span<const int> CarriedPlaces::nodes(int place) const {
  return std::span(node).subspan(start[at(place)], start[at(place) + 1] - start[at(place)]);
}
std::span<const double> CarriedPlaces::shares(int place) const {
  return std::span(share).subspan(start[at(place)], start[at(place) + 1] - start[at(place)]);
}

int CarriedPlaces::add(std::span<const int> of, std::span<const double> shares) {
  for (std::size_t k = 0; k < of.size(); ++k) {
    if (std::abs(shares[k]) > 1e-14) node.push_back(of[k]), share.push_back(shares[k]);
  }
  start.push_back(node.size());
  fixed.resize(fixed.size() + at(dim), 0.0);
  return static_cast<int>(size()) - 1;
}

int CarriedPlaces::add_fixed(const Vec<3>& place) {
  start.push_back(node.size());
  for (int i = 0; i < dim; ++i) fixed.push_back(place[at(i)]);
  return static_cast<int>(size()) - 1;
}

void CarriedPlaces::find(std::span<const double> q, std::vector<double>& x) const {
  const std::size_t d = at(dim);
  x = fixed;
  for (std::size_t p = 0; p < size(); ++p) {
    for (std::size_t k = start[p]; k < start[p + 1]; ++k) {
      for (std::size_t i = 0; i < d; ++i) x[p * d + i] += share[k] * q[at(node[k]) * d + i];
    }
  }
}

void CarriedPlaces::add_to_nodes(std::span<const double> forces, std::span<double> f) const {
  const std::size_t d = at(dim);
  for (std::size_t p = 0; p < size(); ++p) {
    for (std::size_t k = start[p]; k < start[p + 1]; ++k) {
      for (std::size_t i = 0; i < d; ++i) f[at(node[k]) * d + i] += share[k] * forces[p * d + i];
    }
  }
}

}  // namespace tether
