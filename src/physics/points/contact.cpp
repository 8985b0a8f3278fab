// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/contact.hpp"

#include <algorithm>
#include <cmath>

#include "loops/points.hpp"
#include "physics/points/balance.hpp"

namespace tether::mpm {
namespace {

bool is_fluid(const Material& material) {
  return std::holds_alternative<IdealGas>(material) || std::holds_alternative<LinearFluid>(material);
}

Pair pair_of(const Vec<2>& n) { return pair(n[0], n[1]); }

/// Half the distance of a body's points: of a solid by its volume, of a membrane half its thickness.
std::vector<double> radii(const Scene& scene, const Points& P) {
  std::vector<double> of(P.size(), 0.0);
  for (const Body& body : scene.bodies) {
    for_points(Range{body.first, body.first + body.count}, [&](std::size_t p) {
      const double area = P.volume[p] / depth(scene.geometry, P.x[p]);
      of[p] = 0.5 * std::sqrt(area);
      if (!std::holds_alternative<Membrane>(body.material)) return;
      const std::size_t q = p + 1 < body.first + body.count ? p + 1 : p - 1;
      of[p] = 0.5 * area / std::hypot(P.x[p] - P.x[q], P.y[p] - P.y[q]);
    });
  }
  return of;
}

}  // namespace

Contact::Contact(const Scene& scene, const Points& points, const Frame& frame)
    : rule_(scene.method.contact),
      criterion_(scene.method.criterion),
      half_cell_(0.5 * std::max(scene.grid.dx, scene.grid.dy)) {
  const bool fluid =
      std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const auto& body) { return is_fluid(body.material); });
  int common = -1;
  for (const Body& body : scene.bodies) {
    const bool solid = is_solid(body.material);
    if (solid || !fluid) {
      group_of_.push_back(groups_++);
    } else {
      if (common < 0) common = groups_++;
      group_of_.push_back(common);
    }
  }
  if (rule_ == ContactRule::none) groups_ = 1;
  if (!on()) return;
  radius_ = radii(scene, points);
  near_points_.resize(scene.bodies.size());
  pushed_.resize(static_cast<std::size_t>(groups_));
  const std::size_t n = frame.shape.nodes();
  for (auto* array : {&cell_stamp_, &owner_stamp_, &near_stamp_}) array->assign(n, 0);
  owner_.assign(n, 0), slot_.assign(n, -1);
  if (rule_ != ContactRule::release) return;
  const Walls open{Wall::open, Wall::open, Wall::open, Wall::open};  // a padded grid's edges are no walls
  normals_.assign(static_cast<std::size_t>(groups_),
                  BodyNormals(frame.shape, frame.shape == frame.deck ? scene.walls : open));
}

void Contact::begin() {
  ++stamp_;
  for (const int node : nodes_) slot_[static_cast<std::size_t>(node)] = -1;
  nodes_.clear();
}

void Contact::touch(int group, std::size_t node) {
  if (owner_stamp_[node] != stamp_) {
    owner_stamp_[node] = stamp_;
    owner_[node] = group;
  } else if (owner_[node] != group && slot_[node] < 0) {
    slot_[node] = static_cast<int>(nodes_.size());
    nodes_.push_back(static_cast<int>(node));
  }
}

void Contact::open(const Frame& frame) {
  const std::size_t n = nodes_.size() * static_cast<std::size_t>(groups_);
  sums_.assign(n, NodeSums{});
  motion_.assign(n, NodeMotion{});
  convected_.assign(n, Pair{});
  normal_.assign(n, Vec<2>{});
  field_.assign(n, 0);
  if (near_.size() < n) near_.resize(n);
  for (std::size_t k = 0; k < n; ++k) near_[k].clear();
  ghosts_.clear();
  if (nodes_.empty()) return;
  for (const Ghost& ghost : frame.ghosts) {
    if (slot(static_cast<std::size_t>(ghost.image)) >= 0) ghosts_.push_back(ghost);
  }
  for (const int node : nodes_) mark_near(node, frame);
  for (const Ghost& ghost : ghosts_) mark_near(ghost.node, frame);
}

/// Cells, or by splines the surroundings of nodes, are numbered as the node at their lower left or in their middle. The
/// colour at a node comes from points up to two cells away (9.10).
void Contact::mark_near(int node, const Frame& frame) {
  const int reach = rule_ == ContactRule::release ? 2 : 1, nx = frame.shape.nx;
  for (int j = -reach; j <= reach; ++j) {
    for (int i = -reach; i <= reach; ++i) {
      const int cell = node + j * nx + i;
      if (cell >= 0 && cell < static_cast<int>(near_stamp_.size()))
        near_stamp_[static_cast<std::size_t>(cell)] = stamp_;
    }
  }
}

void Contact::clear_forces() {
  for (NodeSums& sum : sums_) sum.force = Pair{};
}

/// (9.7)-(9.9) for the pair of bodies a < b, a the master; the pair's own centre of mass is meant. Criteria 1 and 2
/// have no memory; criterion 3, (9.9), has, by the master's and the other's velocity towards each other:
///
/// | state | both > 0 | both < 0 | they differ, or one is 0 |
/// |---|---|---|---|
/// | joined (at the start) | joined | apart | joined |
/// | apart | joined | apart | apart |
bool Contact::in_contact(int node, int slot, int a, int b) {
  const NodeSums &A = sums_[index(slot, a)], &B = sums_[index(slot, b)];
  const Pair va = A.momentum * inverse(A.m), vb = B.momentum * inverse(B.m);
  const Pair cm = (A.momentum + B.momentum) * inverse(A.m + B.m);
  const Pair outward = pair_of(normal_[index(slot, a)]);
  const double master = dot(criterion_ == 1 ? va - vb : va - cm, outward);
  if (criterion_ != 3) return master > 0;  // (9.7), (9.8)
  const double other = dot(vb - cm, pair_of(normal_[index(slot, b)]));
  const std::pair<int, int> key{node, a * groups_ + b};
  if (master > 0 && other > 0) apart_.erase(key);
  if (master < 0 && other < 0) apart_.insert(key);
  return !apart_.contains(key);
}

/// Bodies that a chain of contacts joins move in one field, that of their common mass.
void Contact::join_fields(int slot) {
  const int node = nodes_[static_cast<std::size_t>(slot)];
  for (int g = 0; g < groups_; ++g) field_[index(slot, g)] = g;
  if (rule_ == ContactRule::gap) return;
  for (int a = 0; a < groups_; ++a) {
    for (int b = a + 1; b < groups_; ++b) {
      if (sums_[index(slot, a)].m <= 0 || sums_[index(slot, b)].m <= 0 || !in_contact(node, slot, a, b)) continue;
      const int low = std::min(field_[index(slot, a)], field_[index(slot, b)]);
      const int high = std::max(field_[index(slot, a)], field_[index(slot, b)]);
      for (int g = 0; g < groups_; ++g) {
        if (field_[index(slot, g)] == high) field_[index(slot, g)] = low;
      }
    }
  }
}

void Contact::decide(const Points& points, const Frame& frame) {
  for (std::size_t g = 0; g < normals_.size() && !nodes_.empty(); ++g) {
    for (std::size_t b = 0; b < near_points_.size(); ++b) {
      if (group_of_[b] != static_cast<int>(g)) continue;
      normals_[g].take({points.x, points.y}, near_points_[b]);
      for (std::size_t k = 0; k < nodes_.size(); ++k) {
        const Vec<2> n = normals_[g].outward(nodes_[k]);
        if (n[0] != 0 || n[1] != 0) normal_[index(static_cast<int>(k), static_cast<int>(g))] = n;
      }
    }
  }
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    join_fields(static_cast<int>(k));
    fields_of(static_cast<int>(k), frame);
  }
}

/// Velocities before the solve (9.3), (9.6).
void Contact::fields_of(int slot, const Frame& frame) {
  for (int g = 0; g < groups_; ++g) {
    Pair momentum{};
    double m = 0;
    for (int other = 0; other < groups_; ++other) {
      if (field_[index(slot, other)] != field_[index(slot, g)]) continue;
      momentum += sums_[index(slot, other)].momentum;
      m += sums_[index(slot, other)].m;
    }
    Pair& v = convected_[index(slot, g)];
    v = momentum * inverse(m);  // (9.3), (9.6)
    hold(frame.held[static_cast<std::size_t>(nodes_[static_cast<std::size_t>(slot)])], v);
  }
}

void Contact::solve(const Points& points, const Frame& frame, double gravity, double dt) {
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const int slot = static_cast<int>(k);
    const std::uint8_t held = frame.held[static_cast<std::size_t>(nodes_[k])];
    for (int g = 0; g < groups_; ++g) {
      NodeSums sum;
      for (int other = 0; other < groups_; ++other) {
        const NodeSums& part = sums_[index(slot, other)];
        if (field_[index(slot, other)] != field_[index(slot, g)]) continue;
        sum.m += part.m, sum.momentum += part.momentum, sum.force += part.force;
      }
      NodeMotion& motion = motion_[index(slot, g)];
      motion.a = sum.force * inverse(sum.m) + pair(0, gravity);  // (9.1), (9.4)
      motion.u = sum.momentum * inverse(sum.m) + dt * motion.a;  // (9.2), (9.5)
      hold(held, motion.a), hold(held, motion.u);
    }
    if (rule_ == ContactRule::gap) impulses(points, frame, slot, dt);
  }
}

void Contact::total(NodeTotals& totals, const Frame& frame, double dt) const {
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const std::uint8_t held = frame.held[static_cast<std::size_t>(nodes_[k])];
    for (int g = 0; g < groups_; ++g) {
      const std::size_t own = index(static_cast<int>(k), g);
      totals.add(sums_[own], motion_[own], held, dt);
    }
  }
}

void Contact::clear_convected() { std::fill(convected_.begin(), convected_.end(), Pair{}); }

void Contact::divide_convected(const Frame& frame) {
  std::vector<Pair>& of = convected_;
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const int slot = static_cast<int>(k);
    for (int g = 0; g < groups_; ++g) {
      if (field_[index(slot, g)] != g) continue;
      Pair momentum{};
      double m = 0;
      for (int other = g; other < groups_; ++other) {
        if (field_[index(slot, other)] != g) continue;
        momentum += of[index(slot, other)];
        m += sums_[index(slot, other)].m;
      }
      Pair v = momentum * inverse(m);
      hold(frame.held[static_cast<std::size_t>(nodes_[k])], v);
      for (int other = g; other < groups_; ++other) {
        if (field_[index(slot, other)] == g) of[index(slot, other)] = v;
      }
    }
  }
}

void Contact::exchange(Grid& grid, int group) {
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const auto n = static_cast<std::size_t>(nodes_[k]);
    const std::size_t own = index(static_cast<int>(k), group);
    grid.convected[n] = std::exchange(convected_[own], Pair(grid.convected[n]));
    grid.motion[n] = std::exchange(motion_[own], NodeMotion(grid.motion[n]));
    if (!grid.squares.empty()) grid.squares[n] = squared(grid.convected[n]) + squared(grid.motion.u[n]);
  }
  for (const Ghost& ghost : ghosts_) {
    const auto n = static_cast<std::size_t>(ghost.node), image = static_cast<std::size_t>(ghost.image);
    grid.convected[n] = ghost.sign * Pair(grid.convected[image]);
    grid.motion[n] = NodeMotion{ghost.sign * Pair(grid.motion.a[image]), ghost.sign * Pair(grid.motion.u[image])};
    if (!grid.squares.empty()) grid.squares[n] = grid.squares[image];
  }
}

std::vector<int> Contact::memory() const {
  std::vector<int> memory;
  for (const auto& [node, pair] : apart_) memory.insert(memory.end(), {node, pair});
  return memory;
}

void Contact::remember(const std::vector<int>& memory) {
  apart_.clear();
  for (std::size_t k = 0; k + 1 < memory.size(); k += 2) apart_.insert({memory[k], memory[k + 1]});
}

}  // namespace tether::mpm
