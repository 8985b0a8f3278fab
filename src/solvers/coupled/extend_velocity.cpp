// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/coupled/extend_velocity.hpp"

#include <algorithm>
#include <cstdint>

namespace tether::coupled {
namespace {

// Those of the faces across an axis that have a velocity.
class Lattice {
 public:
  Lattice(const FlowDomain& domain, int axis, std::vector<double>& v)
      : dim_(domain.grid.dim), size_(domain.grid.faces(axis)), v_(v), known_(v.size()) {
    const auto& kind = domain.face[static_cast<std::size_t>(axis)];
    for (std::size_t f = 0; f < v.size(); ++f) {
      known_[f] = kind[f] != FaceKind::closed;
      if (!known_[f]) v[f] = 0, left_.push_back(f);
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
    std::size_t face;
    double velocity;
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
  std::vector<std::size_t> left_;  // faces that have none yet
  std::vector<Found> found_;
};

}  // namespace

void extend_velocity(const FlowDomain& domain, FaceValues& v, int layers) {
  for (int axis = 0; axis < domain.grid.dim; ++axis) {
    Lattice lattice(domain, axis, v[static_cast<std::size_t>(axis)]);
    for (int layer = 0; layer < layers && lattice.extend(); ++layer) continue;
  }
}

}  // namespace tether::coupled
