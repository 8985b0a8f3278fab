// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/coupled/smoke_passages.hpp"

#include <algorithm>
#include <utility>

namespace tether::coupled {
namespace {

class Finder {
 public:
  Finder(const FlowDomain& domain, int axis, const std::vector<SmokeJet>& jets)
      : domain_(domain), axis_(axis), a_(static_cast<std::size_t>(axis)) {
    for (std::size_t i = 0; i < jets.size(); ++i) {
      if (jets[i].axis == axis) jets_.push_back({jets[i].face, static_cast<int>(i)});
    }
    std::sort(jets_.begin(), jets_.end());
    const std::size_t count = domain.grid.cell_count();
    found_.stride = static_cast<std::ptrdiff_t>(domain.grid.cell(axis == 0, axis == 1, axis == 2));
    found_.up.assign(count, 0.0), found_.down.assign(count, 0.0), found_.has_slope.assign(count, 0.0);
  }

  SmokePassages find(const std::vector<double>& v) {
    std::size_t c = 0;
    const auto& n = domain_.grid.n;
    for (int k = 0; k < n[2]; ++k) {
      for (int j = 0; j < n[1]; ++j) {
        for (int i = 0; i < n[0]; ++i, ++c) {
          if (domain_.kind[c] == CellKind::fluid) look_at({i, j, k}, c, v);
        }
      }
    }
    return std::move(found_);
  }

 private:
  void look_at(const std::array<int, 3>& cell, std::size_t c, const std::vector<double>& v) {
    bool fluid_beside = true;
    for (const bool upper : {false, true}) {
      auto face = cell;
      face[a_] += upper ? 1 : 0;
      const std::size_t f = domain_.grid.face(axis_, face);
      const bool shut = domain_.face[a_][f] == FaceKind::closed, outer = !has_fluid_beyond(cell[a_], c, upper);
      fluid_beside = fluid_beside && !shut && !outer;
      if (shut) continue;
      const double rate = domain_.area[a_][f] * (upper ? v[f] : -v[f]);
      if (rate > 0) (upper ? found_.up : found_.down)[c] = rate;
      if (outer && rate > 0) found_.out.push_back({c, upper, -1, rate});
      if (outer && rate < 0) found_.in.push_back({c, upper, jet_at(f), -rate});
    }
    found_.has_slope[c] = fluid_beside ? 1 : 0;
  }

  bool has_fluid_beyond(int place, std::size_t c, bool upper) const {
    if (place == (upper ? domain_.grid.n[a_] - 1 : 0)) return false;
    const auto stride = static_cast<std::size_t>(found_.stride);
    return domain_.kind[upper ? c + stride : c - stride] == CellKind::fluid;
  }

  int jet_at(std::size_t f) const {
    const auto jet = std::lower_bound(jets_.begin(), jets_.end(), std::pair{f, 0});
    return jet != jets_.end() && jet->first == f ? jet->second : -1;
  }

  const FlowDomain& domain_;
  int axis_;
  std::size_t a_;
  std::vector<std::pair<std::size_t, int>> jets_;  // by face
  SmokePassages found_;
};

}  // namespace

SmokePassages smoke_passages(const FlowDomain& domain, int axis, const std::vector<double>& v,
                             const std::vector<SmokeJet>& jets) {
  return Finder(domain, axis, jets).find(v);
}

}  // namespace tether::coupled
