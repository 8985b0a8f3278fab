// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/coupled/extend_velocity.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace tether::coupled {
namespace {

// Values of a lattice, of faces across an axis or of cells, some of which are known.
class Lattice {
 public:
  Lattice(int dim, const std::array<int, 3>& size, std::vector<std::uint8_t> known, std::vector<double>& v)
      : dim_(dim), size_(size), v_(v), known_(std::move(known)) {
    for (std::size_t f = 0; f < v.size(); ++f) {
      if (known_[f] == 0) v[f] = 0, left_.push_back(f);
    }
  }

  // A further layer; false where there was none.
  bool extend() {
    found_.clear();
    const auto reached = [&](std::size_t f) {
      double mean = 0;
      if (!mean_of_known(f, mean)) return false;
      found_.push_back({f, mean});
      return true;
    };
    left_.erase(std::remove_if(left_.begin(), left_.end(), reached), left_.end());
    for (const auto& [f, mean] : found_) v_[f] = mean, known_[f] = 1;
    return !found_.empty();
  }

 private:
  struct Found {
    std::size_t number;
    double value;
  };

  bool mean_of_known(std::size_t f, double& mean) const {
    double sum = 0;
    int count = 0;
    std::size_t stride = 1, rest = f;
    for (int b = 0; b < dim_; ++b) {
      const auto n = static_cast<std::size_t>(size_[static_cast<std::size_t>(b)]), i = rest % n;
      if (i > 0 && known_[f - stride]) sum += v_[f - stride], ++count;
      if (i + 1 < n && known_[f + stride]) sum += v_[f + stride], ++count;
      rest /= n, stride *= n;
    }
    if (count > 0) mean = sum / count;
    return count > 0;
  }

  int dim_;
  std::array<int, 3> size_;
  std::vector<double>& v_;
  std::vector<std::uint8_t> known_;
  std::vector<std::size_t> left_;  // those that have none yet
  std::vector<Found> found_;
};

}  // namespace

void extend_velocity(const FlowDomain& domain, FaceValues& v, int layers) {
  for (int axis = 0; axis < domain.grid.dim; ++axis) {
    std::vector<std::uint8_t> known;
    for (const FaceKind kind : domain.face[static_cast<std::size_t>(axis)]) known.push_back(kind != FaceKind::closed);
    Lattice lattice(domain.grid.dim, domain.grid.faces(axis), std::move(known), v[static_cast<std::size_t>(axis)]);
    for (int layer = 0; layer < layers && lattice.extend(); ++layer) continue;
  }
}

void extend_pressure(const FlowDomain& domain, std::vector<double>& p, int layers) {
  std::vector<std::uint8_t> known;
  for (const CellKind kind : domain.kind) known.push_back(kind == CellKind::fluid || kind == CellKind::empty);
  Lattice lattice(domain.grid.dim, domain.grid.n, std::move(known), p);
  for (int layer = 0; layer < layers && lattice.extend(); ++layer) continue;
}

}  // namespace tether::coupled
