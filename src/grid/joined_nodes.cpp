// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/joined_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tether {
namespace {

constexpr double tolerance = 1e-9;  // of the mesh's size

double size_of(const Mesh& mesh) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  double size = 0;
  for (std::size_t i = 0; i < dim; ++i) {
    double low = mesh.x[i], high = mesh.x[i];
    for (std::size_t n = i; n < mesh.x.size(); n += dim)
      low = std::min(low, mesh.x[n]), high = std::max(high, mesh.x[n]);
    size = std::max(size, high - low);
  }
  return size;
}

bool coincide(const Mesh& mesh, std::size_t a, std::size_t b, double within) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  for (std::size_t i = 0; i < dim; ++i) {
    if (std::abs(mesh.x[a * dim + i] - mesh.x[b * dim + i]) > within) return false;
  }
  return true;
}

}  // namespace

/// Neighbours in x are looked through.
std::vector<int> lowest_at_place(const Mesh& mesh) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  const double within = tolerance * size_of(mesh);
  std::vector<std::size_t> by_x(mesh.node_count());
  std::iota(by_x.begin(), by_x.end(), std::size_t{0});
  std::sort(by_x.begin(), by_x.end(), [&](std::size_t a, std::size_t b) {
    for (std::size_t i = 0; i < dim; ++i) {  // planes of x within the tolerance count as one
      const double difference = mesh.x[a * dim + i] - mesh.x[b * dim + i];
      if (std::abs(difference) > within) return difference < 0;
    }
    return a < b;
  });
  std::vector<int> lowest(mesh.node_count());
  for (std::size_t k = 0; k < by_x.size(); ++k) {
    const bool again = k > 0 && coincide(mesh, by_x[k - 1], by_x[k], within);
    lowest[by_x[k]] = again ? lowest[by_x[k - 1]] : static_cast<int>(by_x[k]);
  }
  return lowest;
}

std::vector<int> join_nodes(Mesh& mesh) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  const std::vector<int> lowest = lowest_at_place(mesh);
  std::vector<int> number(lowest.size());
  std::vector<double> x;
  for (std::size_t n = 0; n < lowest.size(); ++n) {
    if (lowest[n] != static_cast<int>(n)) {
      number[n] = number[static_cast<std::size_t>(lowest[n])];
      continue;
    }
    number[n] = static_cast<int>(x.size() / dim);
    x.insert(x.end(), &mesh.x[n * dim], &mesh.x[n * dim] + dim);
  }
  for (int& node : mesh.nodes) node = number[static_cast<std::size_t>(node)];
  mesh.x = std::move(x);
  return number;
}

}  // namespace tether
