// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/mesh_velocity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/numbers.hpp"

namespace tether::coupled {
namespace {

constexpr double rounding = 1e-12;  // of a cell
constexpr double cells_of_a_bin = 2;

/// Of shares in a cell: a place that moves by one of these, or that no place of the cell is as near as, has nothing of
/// what stays.
constexpr double lost_by_way = 1.0 / 3, lost_by_change = 1.0 / 6;

/// The place in a cell whose shares are these where they are not below 0, which are made so.
Vec<3> place_within(const FlowMesh& mesh, std::size_t cell, std::array<double, 4> shares) {
  double sum = 0;
  for (double& share : shares) share = std::max(share, 0.0), sum += share;
  Vec<3> x{};
  const auto nodes = mesh.nodes_of(cell);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    for (std::size_t a = 0; a < 3; ++a) x[a] += shares[k] / sum * mesh.x[at(nodes[k])][a];
  }
  return x;
}

double least_of(const std::array<double, 4>& shares, std::size_t count) {
  return *std::min_element(shares.begin(), shares.begin() + static_cast<std::ptrdiff_t>(count));
}

}  // namespace

CellFinder::CellFinder(const FlowMesh& mesh) : mesh_(mesh) {
  constexpr double far = std::numeric_limits<double>::max();
  Vec<3> low{far, far, far}, high{-far, -far, -far};
  double all = 0;
  for (const Vec<3>& x : mesh.x) {
    for (std::size_t a = 0; a < 3; ++a) low[a] = std::min(low[a], x[a]), high[a] = std::max(high[a], x[a]);
  }
  for (const double volume : mesh.volume) all += volume;
  low_ = low;
  width_ = std::pow(cells_of_a_bin * all / static_cast<double>(mesh.cells()), 1.0 / mesh.dim);
  for (std::size_t a = 0; a < at(mesh.dim); ++a)
    n_[a] = std::max(1, static_cast<int>(std::ceil((high[a] - low[a]) / width_)));
  std::vector<std::vector<std::size_t>> lists(at(n_[0]) * at(n_[1]) * at(n_[2]));
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    Vec<3> from{far, far, far}, to{-far, -far, -far};
    for (const int n : mesh.nodes_of(cell)) {
      for (std::size_t a = 0; a < 3; ++a)
        from[a] = std::min(from[a], mesh.x[at(n)][a]), to[a] = std::max(to[a], mesh.x[at(n)][a]);
    }
    const auto first = bin_of(from), last = bin_of(to);
    for (int k = first[2]; k <= last[2]; ++k) {
      for (int j = first[1]; j <= last[1]; ++j) {
        for (int i = first[0]; i <= last[0]; ++i) lists[number({i, j, k})].push_back(cell);
      }
    }
  }
  first_.push_back(0);
  for (const auto& list : lists) {
    cell_.insert(cell_.end(), list.begin(), list.end());
    first_.push_back(cell_.size());
  }
}

std::array<int, 3> CellFinder::bin_of(const Vec<3>& x) const {
  std::array<int, 3> bin{};
  for (std::size_t a = 0; a < 3; ++a)
    bin[a] = std::clamp(static_cast<int>(std::floor((x[a] - low_[a]) / width_)), 0, n_[a] - 1);
  return bin;
}

std::size_t CellFinder::number(const std::array<int, 3>& bin) const {
  return at(bin[0]) + at(n_[0]) * (at(bin[1]) + at(n_[1]) * at(bin[2]));
}

/// First along the straight way from a cell of the place's bin: where the boundary is between, from cell to cell of the
/// bins.
std::size_t CellFinder::cell_at(Vec<3>& x) const {
  const std::size_t bin = number(bin_of(x));
  if (first_[bin] < first_[bin + 1]) {
    Vec<3> there = x;
    int face = -1;
    const std::size_t cell = walk(cell_[(first_[bin] + first_[bin + 1]) / 2], there, face);
    if (face < 0) return cell;
  }
  return nearest_to(x);
}

std::size_t CellFinder::cell_at(Vec<3>& x, std::size_t near) const {
  Vec<3> there = x;
  int face = -1;
  const std::size_t cell = walk(near, there, face);
  return face < 0 ? cell : cell_at(x);
}

std::size_t CellFinder::nearest_to(Vec<3>& x) const {
  const std::array<int, 3> middle = bin_of(x);
  std::size_t best = 0;
  double nearest = std::numeric_limits<double>::max();
  Vec<3> place = x;
  const int most = std::max({n_[0], n_[1], n_[2]});
  for (int reach = 0, rings = 0; reach <= most && rings < 2; ++reach) {
    for (int k = std::max(0, middle[2] - reach); k <= std::min(n_[2] - 1, middle[2] + reach); ++k) {
      for (int j = std::max(0, middle[1] - reach); j <= std::min(n_[1] - 1, middle[1] + reach); ++j) {
        for (int i = std::max(0, middle[0] - reach); i <= std::min(n_[0] - 1, middle[0] + reach); ++i) {
          if (std::max({std::abs(i - middle[0]), std::abs(j - middle[1]), std::abs(k - middle[2])}) != reach) continue;
          const std::size_t bin = number({i, j, k});
          for (std::size_t c = first_[bin]; c < first_[bin + 1]; ++c) {
            const auto shares = mesh_.shares(cell_[c], x);
            if (least_of(shares, mesh_.corners()) >= -rounding) return cell_[c];
            const Vec<3> within = place_within(mesh_, cell_[c], shares), way = minus(within, x);
            const double far = dot(way, way);
            if (far < nearest) nearest = far, best = cell_[c], place = within;
          }
        }
      }
    }
    if (nearest < std::numeric_limits<double>::max()) ++rings;  // the next bins may have a nearer one
  }
  x = place;
  return best;
}

std::size_t CellFinder::walk(std::size_t cell, Vec<3>& x, int& face) const {
  face = -1;
  constexpr int most = 100000;
  for (int step = 0; step < most; ++step) {
    const auto shares = mesh_.shares(cell, x);
    std::size_t out = mesh_.corners();
    double least = -rounding;
    int end = -1;
    for (std::size_t k = 0; k < mesh_.corners(); ++k) {
      if (shares[k] >= -rounding) continue;
      const int f = mesh_.faces_of(cell)[k];
      if (mesh_.is_at_boundary(at(f))) {
        end = f;
      } else if (shares[k] < least) {
        least = shares[k], out = k;
      }
    }
    if (out == mesh_.corners()) {
      face = end;
      if (end >= 0) x = place_within(mesh_, cell, shares);
      return cell;
    }
    const auto& both = mesh_.cells_of_face[at(mesh_.faces_of(cell)[out])];
    cell = at(at(both[0]) == cell ? both[1] : both[0]);
  }
  return cell;
}

MeshVelocity::MeshVelocity(const FlowMesh& mesh, const FaceValues& v) : mesh_(mesh), finder_(mesh) {
  if (mesh.dim == 2) at_node_ = flow_at_nodes(mesh, v);
  at_boundary_ = mesh.nodes_at_boundary();
  for (std::size_t a = 0; a < at(mesh.dim); ++a) along_.emplace_back(mesh, std::span(v[a]).first(mesh.cells()));
}

bool MeshVelocity::is_at_boundary(std::size_t cell) const {
  return std::ranges::any_of(mesh_.nodes_of(cell), [&](int n) { return at_boundary_[at(n)] != 0; });
}

Vec<3> MeshVelocity::velocity(std::size_t cell, const Vec<3>& x) const {
  return at_node_.empty() || is_at_boundary(cell) ? by_cell(cell, x) : by_nodes(cell, x);
}

Vec<3> MeshVelocity::by_nodes(std::size_t cell, const Vec<3>& x) const {
  const auto shares = mesh_.shares(cell, x);
  const auto nodes = mesh_.nodes_of(cell);
  Vec<3> v{};
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const FlowAtNode& flow = at_node_[at(nodes[k])];
    const Vec<3> way = minus(x, mesh_.x[at(nodes[k])]);
    for (std::size_t a = 0; a < 2; ++a)
      v[a] += shares[k] * (flow.v[a] + 0.5 * (flow.slope[a][0] * way[0] + flow.slope[a][1] * way[1]));
  }
  for (std::size_t a = 0; a < 2; ++a) {
    const auto [low, high] = along_[a].extrema(cell);
    const double beyond = high - low;  // what a quadratic flow may have between its extrema at a cell's corners
    v[a] = std::clamp(v[a], low - beyond, high + beyond);
  }
  return v;
}

Vec<3> MeshVelocity::by_cell(std::size_t cell, const Vec<3>& x) const {
  const bool limited = is_at_boundary(cell);
  Vec<3> v{};
  for (std::size_t a = 0; a < along_.size(); ++a)
    v[a] = limited ? along_[a].limited_at(cell, x) : along_[a].at_place(cell, x);
  return v;
}

Vec<3> MeshVelocity::smooth_velocity(std::size_t cell, const Vec<3>& x) const {
  Vec<3> v{};
  const auto shares = mesh_.shares(cell, x);
  for (std::size_t a = 0; a < along_.size(); ++a) v[a] = along_[a].between_means(cell, shares);
  return v;
}

Vec<3> MeshVelocity::with_rest(const Origin& origin, const Vec<3>& x, Vec<3> v) const {
  const Vec<3> here = velocity(origin.from, x);
  for (std::size_t a = 0; a < along_.size(); ++a) {
    const auto [low, high] = along_[a].extrema(origin.from);
    const auto [low_there, high_there] = along_[a].extrema(origin.cell);
    const double least = std::min({low, low_there, v[a]}), most = std::max({high, high_there, v[a]});
    v[a] = std::clamp(v[a] + (1 - origin.part) * (along_[a].value(origin.from) - here[a]), least, most);
  }
  return v;
}

/// By how far the place has come, and is from the nearest of the cell's own places, in shares.
double MeshVelocity::part_lost(std::size_t cell, const Vec<3>& x, const Vec<3>& origin) const {
  const auto now = mesh_.shares(cell, x), before = mesh_.shares(cell, origin);
  const auto nearest = std::max_element(now.begin(), now.begin() + static_cast<std::ptrdiff_t>(mesh_.corners()));
  const double own = share_of_place(mesh_.dim), other = (1 - own) / mesh_.dim;
  double way = 0, change = 0;
  for (std::size_t k = 0; k < mesh_.corners(); ++k) {
    way = std::max(way, std::abs(now[k] - before[k]));
    change = std::max(change, std::abs(now[k] - (&now[k] == &*nearest ? own : other)));
  }
  return std::min(1.0, way / lost_by_way + change / lost_by_change);
}

MeshVelocity::Origin MeshVelocity::before(const Vec<3>& x, double h, std::size_t near) const {
  Vec<3> half = x;
  const std::size_t cell = finder_.cell_at(half, near);
  const auto back = [&](const Vec<3>& v, double time) {
    return Vec<3>{x[0] - time * v[0], x[1] - time * v[1], x[2] - time * v[2]};
  };
  const Vec<3> found = half, v = velocity(cell, half);
  half = back(v, 0.5 * h);
  int met = -1;
  const std::size_t at_half = finder_.walk(cell, half, met);
  Origin origin{.x = back(velocity(at_half, half), h), .from = cell};
  if (found != x) origin.opened_at = static_cast<int>(cell);
  origin.cell = finder_.walk(cell, origin.x, origin.face);
  if (origin.opened_at < 0 && origin.face < 0) origin.part = part_lost(cell, x, origin.x);
  return origin;
}

void hold_energy(const FlowMesh& mesh, double most, Carried& carried) {
  double all = 0, along = 0, of_way = 0;  // the sum is all + 2 part along + part^2 of_way
  const auto each_value = [&](const auto& f) {
    for (std::size_t a = 0; a < at(mesh.dim); ++a) {
      for (std::size_t cell = 0; cell < mesh.cells(); ++cell)
        f(mesh.volume[cell], carried.v[a][cell], carried.smooth[a][cell] - carried.v[a][cell]);
    }
  };
  each_value([&](double volume, double v, double way) {
    all += volume * v * v, along += volume * v * way, of_way += volume * way * way;
  });
  if (all <= most) return;
  const double roots = along * along - of_way * (all - most);
  const double part = along < 0 && roots >= 0 ? std::min(1.0, (all - most) / (std::sqrt(roots) - along)) : 1.0;
  each_value([&](double, double& v, double way) { v += part * way; });
}

}  // namespace tether::coupled
