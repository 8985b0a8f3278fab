// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/cut_faces.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "base/numbers.hpp"

namespace tether::coupled {
namespace {

constexpr double no_part = 1e-9;  // of a box

using Place = std::array<int, 3>;

bool open(const FlowDomain& domain, int axis, const Place& face) {
  const auto m = domain.grid.faces(axis);
  for (std::size_t b = 0; b < face.size(); ++b) {
    if (face[b] < 0 || face[b] >= m[b]) return false;
  }
  return domain.face[at(axis)][domain.grid.face(axis, face)] == FaceKind::open;
}

/// Returns whether fluid goes straight from one of the two cells beside a face to the same one beside the next face on
/// a side.
bool joined(const FlowDomain& domain, int axis, const Place& face, int across, bool up) {
  if (across == axis) return true;  // both are faces of one cell
  for (const int back : {1, 0}) {
    Place between = face;
    between[at(axis)] -= back, between[at(across)] += up ? 1 : 0;
    if (open(domain, across, between)) return true;
  }
  return false;
}

/// Of a face's velocity and those of the faces beside it that it is joined to.
struct Around {
  double mean = 0;     ///< by volume
  double fastest = 0;  ///< the largest size
};

Around around(const FlowDomain& domain, int axis, std::size_t f, const std::vector<double>& v) {
  const StaggeredGrid& grid = domain.grid;
  const std::vector<double>& volume = domain.volume[at(axis)];
  const Place place = grid.place_of_face(axis, f);
  double sum = volume[f] * v[f], weights = volume[f], fastest = std::abs(v[f]);
  for (int across = 0; across < grid.dim; ++across) {
    for (const bool up : {false, true}) {
      Place next = place;
      next[at(across)] += up ? 1 : -1;
      if (!open(domain, axis, next) || !joined(domain, axis, place, across, up)) continue;
      const std::size_t g = grid.face(axis, next);
      sum += volume[g] * v[g], weights += volume[g], fastest = std::max(fastest, std::abs(v[g]));
    }
  }
  return {sum / weights, fastest};
}

}  // namespace

void blend_cut_faces(const FlowDomain& domain, double h, FaceValues& v) { blend_cut_faces(domain, domain, h, v); }

void blend_cut_faces(const FlowDomain& domain, const FlowDomain& room, double h, FaceValues& v) {
  const StaggeredGrid& grid = domain.grid;
  for (int axis = 0; axis < grid.dim; ++axis) {
    const std::vector<double> before = v[at(axis)];
    for (std::size_t f = 0; f < before.size(); ++f) {
      if (domain.face[at(axis)][f] != FaceKind::open) continue;
      const int i = grid.place_of_face(axis, f)[at(axis)];
      const double whole = grid.volume() * (i == 0 || i == grid.n[at(axis)] ? 0.5 : 1),
                   lacks = 1 - room.volume[at(axis)][f] / whole;
      if (lacks < no_part) continue;
      const Around about = around(domain, axis, f, before);
      const double taken = lacks * -std::expm1(-h * about.fastest / grid.d[at(axis)]);
      v[at(axis)][f] += taken * (about.mean - before[f]);
    }
  }
}

namespace {

// Values of a lattice, of faces across an axis or of cells, some of which are known.
class Lattice {
 public:
  Lattice(int dim, const std::array<int, 3>& size, std::vector<std::uint8_t> known, double most_change,
          std::vector<double>& v)
      : dim_(dim), size_(size), most_change_(most_change), v_(v), known_(std::move(known)) {
    for (std::size_t f = 0; f < v.size(); ++f) {
      if (known_[f] == 0) v[f] = 0, left_.push_back(f);
    }
  }

  std::vector<std::uint8_t> take_known() { return std::move(known_); }

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
      if (i > 0 && known_[f - stride]) sum += said_by(f - stride, i > 1 ? f - 2 * stride : f), ++count;
      if (i + 1 < n && known_[f + stride]) sum += said_by(f + stride, i + 2 < n ? f + 2 * stride : f), ++count;
      rest /= n, stride *= n;
    }
    if (count > 0) mean = sum / count;
    return count > 0;
  }

  // What a known value says of the place next to it, away from a second one, if there is one.
  double said_by(std::size_t near, std::size_t second) const {
    if (most_change_ == 0 || known_[second] == 0) return v_[near];
    return v_[near] + std::clamp(v_[near] - v_[second], -most_change_, most_change_);
  }

  int dim_;
  std::array<int, 3> size_;
  double most_change_;
  std::vector<double>& v_;
  std::vector<std::uint8_t> known_;
  std::vector<std::size_t> left_;  // those that have none yet
  std::vector<Found> found_;
};

}  // namespace

std::vector<std::uint8_t> extend_known(int dim, const std::array<int, 3>& size, std::vector<std::uint8_t> known,
                                       int layers, std::vector<double>& values, double most_change) {
  Lattice lattice(dim, size, std::move(known), most_change, values);
  for (int layer = 0; layer < layers && lattice.extend(); ++layer) continue;
  return lattice.take_known();
}

void extend_velocity(const FlowDomain& domain, FaceValues& v, int layers) {
  for (int axis = 0; axis < domain.grid.dim; ++axis) {
    std::vector<std::uint8_t> known;
    for (const FaceKind kind : domain.face[at(axis)]) known.push_back(kind != FaceKind::closed);
    extend_known(domain.grid.dim, domain.grid.faces(axis), std::move(known), layers, v[at(axis)]);
  }
}

void extend_pressure(const FlowDomain& domain, std::vector<double>& p, int layers) {
  std::vector<std::uint8_t> known;
  for (const CellKind kind : domain.kind) known.push_back(kind == CellKind::fluid || kind == CellKind::empty);
  extend_known(domain.grid.dim, domain.grid.n, std::move(known), layers, p);
}

}  // namespace tether::coupled
