// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "grid/boxes.hpp"
#include "loops/line_allocator.hpp"

namespace tether::mpm {

// Fields of nodes as rows of numbers, a component apart: neighbours along x stand side by side, so that a lane of the
// processor can stand for a node. One node's values are read and written through what the brackets return.

/// A number at each node.
class NodeRow {
 public:
  /// Nodes that a group of lanes may reach to before the first node and after the last one.
  static constexpr std::size_t margin = 16;

  /// Rows of one node's numbers must not all fall on one place of the cache: each is `shift` lines further on.
  explicit NodeRow(std::size_t nodes = 0, std::size_t shift = 0)
      : first_(margin + numbers_in_line * shift), nodes_(nodes), numbers_(first_ + nodes + margin) {}
  NodeRow(const NodeRow& other) : first_(other.first_), nodes_(other.nodes_), numbers_(other.numbers_) {}
  NodeRow(NodeRow&& other) noexcept { *this = std::move(other); }
  NodeRow& operator=(const NodeRow& other) { return *this = NodeRow(other); }
  NodeRow& operator=(NodeRow&& other) noexcept {
    first_ = other.first_, nodes_ = std::exchange(other.nodes_, 0), numbers_ = std::move(other.numbers_);
    node_0_ = std::exchange(other.node_0_, nullptr);
    return *this;
  }
  ~NodeRow() = default;

  std::size_t size() const { return nodes_; }
  bool empty() const { return nodes_ == 0; }
  double& operator[](std::size_t n) { return node_0_[n]; }
  double operator[](std::size_t n) const { return node_0_[n]; }
  double* data() { return node_0_; }
  const double* data() const { return node_0_; }
  void clear() { std::fill(numbers_.begin(), numbers_.end(), 0.0); }

 private:
  static constexpr std::size_t numbers_in_line = 8;
  std::size_t first_ = 0, nodes_ = 0;
  std::vector<double, ZeroAllocator<double>> numbers_;
  double* node_0_ = numbers_.data() + first_;
};

/// A vector of one node, where its components are stored.
struct PairAt {
  double& x;
  double& y;

  operator Pair() const { return pair(x, y); }
  double& operator[](int component) const { return component == 0 ? x : y; }
  PairAt& operator=(Pair v) {
    x = v[0], y = v[1];
    return *this;
  }
  PairAt& operator=(const PairAt& v) { return *this = Pair(v); }
  PairAt(const PairAt&) = default;
  PairAt(double& x_, double& y_) : x(x_), y(y_) {}
  PairAt& operator+=(Pair v) { return *this = Pair(*this) + v; }
  PairAt& operator*=(double factor) { return *this = factor * Pair(*this); }
};

/// A vector at each node.
struct PairRow {
  NodeRow x, y;

  explicit PairRow(std::size_t nodes = 0, std::size_t shift = 0) : x(nodes, shift), y(nodes, shift + 1) {}
  std::size_t size() const { return x.size(); }
  PairAt operator[](std::size_t n) { return {x[n], y[n]}; }
  Pair operator[](std::size_t n) const { return pair(x[n], y[n]); }
  void clear() { x.clear(), y.clear(); }
};

/// Sums over points at a node, mapped at the start of a step (3.15)-(3.18).
struct NodeSums {
  Pair momentum{}, force{};
  double m = 0, gas = 0;  // mass, and that of the gas where its density comes from the nodes
};

/// The sums of one node, where they are stored.
struct NodeSumsAt {
  PairAt momentum, force;
  double& m;
  double& gas;

  operator NodeSums() const { return {momentum, force, m, gas}; }
  NodeSumsAt& operator=(const NodeSums& sums) {
    momentum = sums.momentum, force = sums.force;
    m = sums.m, gas = sums.gas;
    return *this;
  }
};

/// The sums at each node.
struct NodeSumsRow {
  PairRow momentum, force;
  NodeRow m, gas;

  explicit NodeSumsRow(std::size_t nodes, std::size_t shift = 0)
      : momentum(nodes, shift), force(nodes, shift + 2), m(nodes, shift + 4), gas(nodes, shift + 5) {}
  std::size_t size() const { return m.size(); }
  NodeSumsAt operator[](std::size_t n) { return {momentum[n], force[n], m[n], gas[n]}; }
  NodeSums operator[](std::size_t n) const { return {momentum[n], force[n], m[n], gas[n]}; }
  void clear() { momentum.clear(), force.clear(), m.clear(), gas.clear(); }
};

/// Solution of the momentum equation at a node: acceleration f / m and velocity (mv)^L / m (3.19), (3.20).
/// The quotients are taken at the node. The thesis' momentum form multiplies by N_i first so that a tiny m_i cancels;
/// in floating point the order is of no matter as long as nothing overflows, and N_i >= 1e-24 (Locator::edge).
struct NodeMotion {
  Pair a{}, u{};
};

/// That of one node, where it is stored.
struct NodeMotionAt {
  PairAt a, u;

  operator NodeMotion() const { return {a, u}; }
  NodeMotionAt& operator=(const NodeMotion& motion) {
    a = motion.a, u = motion.u;
    return *this;
  }
};

/// That of each node.
struct NodeMotionRow {
  PairRow a, u;

  explicit NodeMotionRow(std::size_t nodes, std::size_t shift = 0) : a(nodes, shift), u(nodes, shift + 2) {}
  NodeMotionAt operator[](std::size_t n) { return {a[n], u[n]}; }
  NodeMotion operator[](std::size_t n) const { return {a[n], u[n]}; }
};

/// What the gas reads at each node: its density there, and the heat per mass that the ledger gives it.
struct NodeGasRow {
  NodeRow rho, heat;

  explicit NodeGasRow(std::size_t nodes, std::size_t shift = 0) : rho(nodes, shift), heat(nodes, shift + 1) {}
};

}  // namespace tether::mpm
