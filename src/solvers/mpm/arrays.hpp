// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "grid/background_grid.hpp"
#include "grid/pair.hpp"
#include "laws/walls/walls.hpp"
#include "scene/scene.hpp"

namespace tether::mpm {

/// All material points, an array a property. A point keeps its number (its place in the scene) in `id` while sorting
/// moves it from slot to slot; a body keeps its range of slots.
struct Points {
  std::vector<double> x, y, vx, vy;   // [length], [velocity]
  std::vector<double> mass, volume;   // m_p and the stored V_p; a gas has V_p = m_p / rho instead
  std::vector<double> sxx, syy, sxy;  // sigma_p [stress]
  std::vector<double> rho, energy;    // gas: density, specific internal energy i
  std::vector<double> strain;         // string: eps_1'; linear fluid: its pressure is -sxx
  std::vector<double> tx, ty;         // string: unit tangent t
  std::vector<double> dxx, dyy, dxy;  // eps' of this step, for laws that need their neighbours' new places first
  std::vector<int> id;

  explicit Points(const PointSet& initial);
  std::size_t size() const { return x.size(); }
};

/// Sums over points at a node, mapped at the start of a step (3.15)-(3.18).
struct NodeSums {
  Pair momentum{}, force{};
  double m = 0;
};

/// Solution of the momentum equation at a node: acceleration f / m and velocity (mv)^L / m (3.19), (3.20).
/// The quotients are taken at the node. The thesis' momentum form multiplies by N_i first so that a tiny m_i cancels;
/// in floating point the order is of no matter as long as nothing overflows, and N_i >= 1e-24 (Locator::edge).
struct NodeMotion {
  Pair a{}, u{};
};

/// The background grid's fields, and the lists of cells and nodes that hold points: nothing else is touched in a step.
struct Grid {
  BackgroundGrid shape;
  std::vector<NodeSums> sums;
  std::vector<NodeMotion> motion;
  std::vector<Pair> convected;     // (3.24): first sum m v N, then divided by m
  std::vector<std::uint8_t> held;  // Held bits of the walls
  std::vector<int> active_cells, active_nodes;
  std::vector<std::uint32_t> cell_stamp, node_stamp;  // the list in which a cell or node stands already
  std::uint32_t stamp = 0;

  Grid(const BackgroundGrid& shape, const Walls& walls, std::size_t points);
  /// Lists the cells that hold points, and their nodes. The places must lie inside the grid.
  void list_active(const Points& points);
};

}  // namespace tether::mpm
