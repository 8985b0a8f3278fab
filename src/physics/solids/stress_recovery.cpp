// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solids/stress_recovery.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "algebra/dense.hpp"
#include "physics/solids/elements.hpp"

namespace tether::fem {
namespace {

constexpr int most_layers = 2;  // of elements that are added to those around a corner
// Of the spread of samples, over its largest: along a way below this a slope is not determined, a curvature neither.
constexpr double least_spread = 0.25, least_curved = 0.15;

/// Which elements each node has.
std::vector<std::vector<int>> elements_of_nodes(const Mesh& mesh) {
  std::vector<std::vector<int>> elements(mesh.node_count());
  const auto per_element = static_cast<std::size_t>(node_count_of(mesh.kind));
  for (std::size_t k = 0; k < mesh.nodes.size(); ++k)
    elements[static_cast<std::size_t>(mesh.nodes[k])].push_back(static_cast<int>(k / per_element));
  return elements;
}

/// Squares and products of two of a place's coordinates.
Eigen::RowVectorXd products_of(const Eigen::RowVectorXd& x) {
  const Eigen::Index dim = x.size();
  Eigen::RowVectorXd products(dim * (dim + 1) / 2);
  for (Eigen::Index i = 0, k = 0; i < dim; ++i) {
    for (Eigen::Index j = i; j < dim; ++j) products[k++] = x[i] * x[j];
  }
  return products;
}

/// The solution of least squares of columns `data` by columns A, of which coordinates are of size 1, without the ways
/// along which A spreads less than `least` of the most, or nearly not at all; `whole` says whether there are none such.
Eigen::MatrixXd fitted(const Eigen::MatrixXd& A, const Eigen::MatrixXd& data, double least, bool& whole) {
  const EigenParts normal = eigen_parts(A.transpose() * A);
  constexpr double small = 0.05;
  const double most = std::max(normal.values.maxCoeff(), small * static_cast<double>(A.rows()));
  Eigen::VectorXd inverse = Eigen::VectorXd::Zero(A.cols());
  whole = true;
  for (Eigen::Index k = 0; k < A.cols(); ++k) {
    const bool spread = normal.values[k] > least * least * most;
    if (spread) inverse[k] = 1 / normal.values[k];
    whole &= spread;
  }
  return normal.vectors * (inverse.asDiagonal() * (normal.vectors.transpose() * (A.transpose() * data)));
}

/// A linear function of place: a row of constants, and slopes.
struct Linear {
  Eigen::RowVectorXd constant;
  Eigen::MatrixXd slope;

  /// Fits it to the data at the places, a row each.
  Linear(const Eigen::MatrixXd& places, const Eigen::MatrixXd& data, bool& whole) {
    const Eigen::RowVectorXd centre = places.colwise().mean();
    slope = fitted(places.rowwise() - centre, data, least_spread, whole);
    constant = data.colwise().mean() - centre * slope;
  }
  Linear() = default;
  Eigen::RowVectorXd at(const Eigen::RowVectorXd& x) const { return constant + x * slope; }
};

/// The elements of one region around a corner, and the polynomial that fits their stress: a linear function, and of
/// order 2 that part of curvatures that the samples around the corner itself determine. Curvatures across a boundary,
/// for which farther elements would be needed, cost more than they bring on all but fine meshes.
class Patch {
 public:
  Patch(const Mesh& mesh, const StressSamples& samples, const std::vector<std::vector<int>>& of_nodes)
      : mesh_(mesh), samples_(samples), of_nodes_(of_nodes), dim_(static_cast<std::size_t>(mesh.dim())) {}

  /// Fits to the elements, of one region, about the place of a node; false where they do not determine slopes.
  bool fit(std::vector<int> elements, std::size_t node) {
    node_ = node;
    for (int layer = 0;; ++layer) {
      if (solve(elements)) return true;
      const std::size_t before = elements.size();
      if (layer < most_layers) grow(elements);
      if (elements.size() == before) return false;
    }
  }
  /// The stress by the polynomial at another node.
  std::array<double, stress_parts> at_node(std::size_t node) const {
    const Eigen::RowVectorXd x = place(&mesh_.x[node * dim_]);
    std::array<double, stress_parts> stress;
    Eigen::Map<Eigen::RowVectorXd> values(stress.data(), stress_parts);
    values = stress_.at(x);
    if (samples_.order == 2) values += (products_of(x) - products_.at(x)) * curvature_;
    return stress;
  }

 private:
  /// A place about that of the node, over the size of the patch.
  Eigen::RowVectorXd place(const double* x) const {
    Eigen::RowVectorXd from(static_cast<Eigen::Index>(dim_));
    for (std::size_t i = 0; i < dim_; ++i)
      from[static_cast<Eigen::Index>(i)] = (x[i] - mesh_.x[node_ * dim_ + i]) / size_;
    return from;
  }
  /// Adds the elements of the same region that share a node with one that is there.
  void grow(std::vector<int>& elements) const {
    const int region = mesh_.region[static_cast<std::size_t>(elements.front())];
    for (std::size_t k = 0, count = elements.size(); k < count; ++k) {
      const int* nodes = mesh_.element(static_cast<std::size_t>(elements[k]));
      for (int a = 0; a < node_count_of(mesh_.kind); ++a) {
        for (const int e : of_nodes_[static_cast<std::size_t>(nodes[a])]) {
          if (mesh_.region[static_cast<std::size_t>(e)] == region) elements.push_back(e);
        }
      }
    }
    std::sort(elements.begin(), elements.end());
    elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
  }
  /// Finds slopes, and then curvatures of what these leave.
  bool solve(const std::vector<int>& elements) {
    const auto rows = static_cast<Eigen::Index>(elements.size()) * samples_.per_element;
    const auto columns = static_cast<Eigen::Index>(dim_);
    // One sample an element scatters from each to the next.
    if (rows < (samples_.order == 1 ? 2 * columns : columns + 1)) return false;
    Eigen::MatrixXd places(rows, columns), products(rows, columns * (columns + 1) / 2), stress(rows, stress_parts);
    size_ = 1, size_ = size_of(elements);
    Eigen::Index k = 0;
    each_sample(elements, [&](std::size_t s) {
      places.row(k) = place(&samples_.places[s * dim_]);
      products.row(k) = products_of(places.row(k));
      stress.row(k++) = Eigen::Map<const Eigen::RowVectorXd>(&samples_.stress[s * stress_parts], stress_parts);
    });
    bool whole = true, curved = true;
    stress_ = Linear(places, stress, whole);
    if (!whole || samples_.order == 1) return whole;
    products_ = Linear(places, products, whole);
    for (k = 0; k < rows; ++k)
      products.row(k) -= products_.at(places.row(k)), stress.row(k) -= stress_.at(places.row(k));
    curvature_ = fitted(products, stress, least_curved, curved);
    return true;
  }
  /// Calls f with the number of each sample of the elements.
  template <class Function>
  void each_sample(const std::vector<int>& elements, const Function& f) const {
    for (const int e : elements) {
      for (int s = e * samples_.per_element; s < (e + 1) * samples_.per_element; ++s) f(static_cast<std::size_t>(s));
    }
  }
  /// The largest distance of a sample from the node.
  double size_of(const std::vector<int>& elements) const {
    double size = 0;
    each_sample(elements, [&](std::size_t s) { size = std::max(size, place(&samples_.places[s * dim_]).norm()); });
    return size;
  }

  const Mesh& mesh_;
  const StressSamples& samples_;
  const std::vector<std::vector<int>>& of_nodes_;
  std::size_t dim_, node_ = 0;
  double size_ = 1;
  Linear stress_, products_;
  Eigen::MatrixXd curvature_;
};

/// Sums over fits, with the volumes that they count by.
struct FittedSums {
  std::vector<double> stress, volume;

  explicit FittedSums(std::size_t nodes) : stress(nodes * stress_parts, 0.0), volume(nodes, 0.0) {}
  void add(std::size_t node, double part, const std::array<double, stress_parts>& of) {
    volume[node] += part;
    for (std::size_t f = 0; f < stress_parts; ++f) stress[node * stress_parts + f] += part * of[f];
  }
};

}  // namespace

void fit_stress(const Mesh& mesh, const StressSamples& samples, std::span<double> nodal) {
  const std::vector<std::vector<int>> of_nodes = elements_of_nodes(mesh);
  const std::vector<int> corners = corners_of(mesh.kind);
  std::vector<char> is_corner(mesh.node_count(), 0);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (const int c : corners) is_corner[static_cast<std::size_t>(mesh.element(e)[c])] = 1;
  }
  FittedSums sums(mesh.node_count());
  Patch patch(mesh, samples, of_nodes);
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    if (!is_corner[n]) continue;
    std::map<int, std::vector<int>> by_region;
    for (const int e : of_nodes[n]) by_region[mesh.region[static_cast<std::size_t>(e)]].push_back(e);
    for (const auto& [region, elements] : by_region) {
      if (!patch.fit(elements, n)) continue;
      for (const int e : elements) {
        const double volume = samples.volumes[static_cast<std::size_t>(e)];
        const int* nodes = mesh.element(static_cast<std::size_t>(e));
        for (int a = 0; a < node_count_of(mesh.kind); ++a) {
          const auto node = static_cast<std::size_t>(nodes[a]);
          if (node == n || !is_corner[node]) sums.add(node, volume, patch.at_node(node));
        }
      }
    }
  }
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    for (std::size_t f = 0; f < stress_parts && sums.volume[n] > 0; ++f)
      nodal[n * stress_fields + f] = sums.stress[n * stress_parts + f] / sums.volume[n];
  }
}

}  // namespace tether::fem
