// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/liquid/extend.hpp"

#include <algorithm>
#include <cstdint>

#include "base/numbers.hpp"
#include "physics/box/liquid/surface.hpp"

namespace tether::liquid {
namespace {

using coupled::FaceKind;
using coupled::FlowDomain;

constexpr int linear_layers = 2;

/// The faces across one axis, of which some have a velocity.
class Faces {
 public:
  Faces(const FlowDomain& room, const FlowDomain& liquid, std::span<const double> distance, int axis,
        std::vector<double>& v)
      : grid_(room.grid), axis_(axis), v_(v), state_(v.size(), nothing), distance_(v.size()) {
    const auto m = grid_.faces(axis);
    size_ = m, stride_ = {1, m[0], m[0] * m[1]};
    for (std::size_t f = 0; f < v.size(); ++f) {
      const auto [low, high] = coupled::cells_beside(grid_, axis, f);
      distance_[f] = 0.5 * (distance[at(low < 0 ? high : low)] + distance[at(high < 0 ? low : high)]);
      if (room.face[at(axis)][f] == FaceKind::prescribed)
        state_[f] = wall;
      else if (moves_liquid(liquid, distance, axis, f))
        state_[f] = given;
      else
        left_.push_back(f);
    }
  }

  /// Faces of walls next to a jet that blows in take its velocity: particles at its edge are not to see the wall's.
  void spread_jets() {
    std::vector<std::pair<std::size_t, double>> found;
    for (std::size_t f = 0; f < v_.size(); ++f) {
      if (state_[f] != wall || v_[f] != 0) continue;
      const auto place = grid_.place_of_face(axis_, f);
      if (place[at(axis_)] != 0 && place[at(axis_)] != grid_.n[at(axis_)]) continue;
      const double inwards = place[at(axis_)] == 0 ? 1 : -1;
      double most = 0;
      for (std::size_t b = 0; b < static_cast<std::size_t>(grid_.dim); ++b) {
        for (const int way : {-1, 1}) {
          if (static_cast<int>(b) == axis_ || place[b] + way < 0 || place[b] + way >= size_[b]) continue;
          const auto next = f + static_cast<std::size_t>(way * stride_[b]);
          if (state_[next] == wall) most = std::max(most, inwards * v_[next]);
        }
      }
      if (most > 0) found.emplace_back(f, inwards * most);
    }
    for (const auto& [f, value] : found) v_[f] = value;
  }

  /// Faces that are open to particles, and that these reached, keep their velocity.
  void keep_reached(const FlowDomain& room, const std::vector<double>& reached, const std::vector<double>& before) {
    const auto keeps = [&](std::size_t f) {
      if (reached[f] <= 0 || room.face[at(axis_)][f] != FaceKind::open) return false;
      v_[f] = before[f], state_[f] = given;
      return true;
    };
    left_.erase(std::remove_if(left_.begin(), left_.end(), keeps), left_.end());
  }

  void extend(bool linear) {
    found_.clear();
    const auto reaches = [&](std::size_t f) {
      double value = 0;
      if (!from_around(f, linear, value)) return false;
      found_.emplace_back(f, value);
      return true;
    };
    left_.erase(std::remove_if(left_.begin(), left_.end(), reaches), left_.end());
    for (const auto& [f, value] : found_) v_[f] = value, state_[f] = given;
  }

  void clear_rest() {
    for (const std::size_t f : left_) v_[f] = 0;
  }

 private:
  enum State : std::uint8_t { nothing, given, wall };

  /// The mean of what faces nearer the liquid say, by how much nearer they are.
  bool from_around(std::size_t f, bool linear, double& value) const {
    constexpr double level = 1e-12;  // so that faces as near count where there are no nearer ones
    const auto place = grid_.place_of_face(axis_, f);
    double sum = 0, weights = 0;
    for (std::size_t b = 0; b < static_cast<std::size_t>(grid_.dim); ++b) {
      for (const int way : {-1, 1}) {
        const int i = place[b] + way, beyond = i + way;
        if (i < 0 || i >= size_[b]) continue;
        const auto next = f + static_cast<std::size_t>(way * stride_[b]);
        if (state_[next] != given) continue;
        double said = v_[next];
        if (linear && beyond >= 0 && beyond < size_[b]) {
          const auto second = next + static_cast<std::size_t>(way * stride_[b]);
          if (state_[second] == given) said = 2 * said - v_[second];
        }
        const double weight = std::max(distance_[f] - distance_[next], 0.0) + level;
        sum += weight * said, weights += weight;
      }
    }
    if (weights > 0) value = sum / weights;
    return weights > 0;
  }

  const StaggeredGrid& grid_;
  int axis_;
  std::array<int, 3> size_{}, stride_{};
  std::vector<double>& v_;
  std::vector<State> state_;
  std::vector<double> distance_;  // of each face [cells]
  std::vector<std::size_t> left_;
  std::vector<std::pair<std::size_t, double>> found_;
};

}  // namespace

void extend_about_liquid(const FlowDomain& room, const FlowDomain& liquid, std::span<const double> distance,
                         const coupled::FaceValues& reached, int layers, coupled::FaceValues& v) {
  for (int axis = 0; axis < room.grid.dim; ++axis) {
    const std::vector<double> before = v[at(axis)];
    Faces faces(room, liquid, distance, axis, v[at(axis)]);
    faces.spread_jets();
    for (int layer = 0; layer < linear_layers; ++layer) faces.extend(true);
    faces.keep_reached(room, reached[at(axis)], before);
    for (int layer = 0; layer < layers; ++layer) faces.extend(false);
    faces.clear_rest();
  }
}

}  // namespace tether::liquid
