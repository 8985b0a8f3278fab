// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/coupled/smoke_passages.hpp"

#include <algorithm>
#include <cmath>
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
  }

  std::vector<SmokePassage> find(const std::vector<double>& v) {
    const auto m = domain_.grid.faces(axis_);
    std::vector<SmokePassage> found;
    found.reserve(v.size());
    std::size_t f = 0;
    for (int k = 0; k < m[2]; ++k) {
      for (int j = 0; j < m[1]; ++j) {
        for (int i = 0; i < m[0]; ++i, ++f) {
          if (domain_.face[a_][f] == FaceKind::closed) continue;
          const double rate = domain_.area[a_][f] * v[f];
          if (rate != 0) add(f, {i, j, k}, rate, found);
        }
      }
    }
    return found;
  }

 private:
  void add(std::size_t f, const std::array<int, 3>& face, double rate, std::vector<SmokePassage>& found) const {
    auto from = face, to = face;
    (rate > 0 ? from : to)[a_] -= 1;
    SmokePassage passage{.from = fluid_cell(from), .to = fluid_cell(to), .rate = std::abs(rate)};
    if (passage.from < 0 && passage.to < 0) return;
    if (passage.from >= 0) passage.behind = cell_behind(face, from, rate > 0 ? 1 : -1);
    if (passage.from < 0 && domain_.face[a_][f] == FaceKind::prescribed) passage.jet = jet_at(f);
    found.push_back(passage);
  }

  int fluid_cell(const std::array<int, 3>& place) const {
    if (!domain_.grid.has_cell(place)) return -1;
    const std::size_t c = domain_.grid.cell(place);
    return domain_.kind[c] == CellKind::fluid ? static_cast<int>(c) : -1;
  }

  int cell_behind(std::array<int, 3> face, std::array<int, 3> cell, int along) const {
    face[a_] -= along, cell[a_] -= along;
    const bool shut = domain_.face[a_][domain_.grid.face(axis_, face)] == FaceKind::closed;
    return shut ? -1 : fluid_cell(cell);
  }

  int jet_at(std::size_t f) const {
    const auto jet = std::lower_bound(jets_.begin(), jets_.end(), std::pair{f, 0});
    return jet != jets_.end() && jet->first == f ? jet->second : -1;
  }

  const FlowDomain& domain_;
  int axis_;
  std::size_t a_;
  std::vector<std::pair<std::size_t, int>> jets_;  // by face
};

}  // namespace

std::array<std::vector<SmokePassage>, 3> smoke_passages(const FlowDomain& domain, const FaceValues& v,
                                                        const std::vector<SmokeJet>& jets) {
  std::array<std::vector<SmokePassage>, 3> passages;
  for (int axis = 0; axis < domain.grid.dim; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    passages[a] = Finder(domain, axis, jets).find(v[a]);
  }
  return passages;
}

}  // namespace tether::coupled
