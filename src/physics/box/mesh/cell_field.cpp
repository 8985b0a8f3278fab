// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/cell_field.hpp"

#include "base/numbers.hpp"

namespace tether::coupled {

CellField::CellField(const FlowMesh& mesh, std::span<const double> values, std::span<const FaceValue> known)
    : mesh_(mesh), values_(values), mean_(mesh.x.size(), 0.0), slope_(mesh.cells()) {
  std::vector<double> weight(mesh.x.size(), 0.0);
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    for (const int n : mesh.nodes_of(cell))
      weight[at(n)] += mesh.volume[cell], mean_[at(n)] += mesh.volume[cell] * values[cell];
  }
  for (std::size_t n = 0; n < weight.size(); ++n) mean_[n] /= weight[n];
  for (const FaceValue& of : known) {
    for (const int n : mesh.face_nodes(of.face)) weight[at(n)] = mean_[at(n)] = 0;
  }
  for (const FaceValue& of : known) {
    for (const int n : mesh.face_nodes(of.face)) {
      weight[at(n)] += mesh.size_of(of.face);
      mean_[at(n)] += (of.value - mean_[at(n)]) * mesh.size_of(of.face) / weight[at(n)];
    }
  }
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    for (std::size_t k = 0; k < mesh.corners(); ++k) {
      const Vec<3>& of_share = mesh.share_slope[cell * mesh.corners() + k];
      const double mean = mean_[at(mesh.nodes_of(cell)[k])];
      for (std::size_t b = 0; b < at(mesh.dim); ++b) slope_[cell][b] += mean * of_share[b];
    }
  }
}

std::array<double, 2> CellField::extrema(std::size_t cell) const {
  double low = values_[cell], high = low;
  for (const int n : mesh_.nodes_of(cell)) low = std::min(low, mean_[at(n)]), high = std::max(high, mean_[at(n)]);
  return {low, high};
}

}  // namespace tether::coupled
