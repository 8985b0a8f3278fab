// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "grid/background_grid.hpp"
#include "grid/pair.hpp"
#include "model/scene.hpp"
#include "solvers/mpm/frame.hpp"

namespace tether::mpm {

/// All material points, an array a property. A point keeps its number (its place in the scene) in `id` while sorting
/// moves it from slot to slot; a body keeps its range of slots.
struct Points {
  std::vector<double> x, y, vx, vy;        // [length], [velocity]
  std::vector<double> mass, volume;        // m_p and the stored V_p; a gas has V_p = m_p / rho instead
  std::vector<double> vxx, vyx, vxy, vyy;  // APIC: the field about the point, vyx = d v_y / d x [1/time]
  std::vector<double> sxx, syy, sxy;       // sigma_p [stress]
  std::vector<double> szz;                 // about an axis: its hoop stress [stress]
  std::vector<double> rho, energy;         // gas: density, specific internal energy i
  std::vector<double> strain, hoop;  // membrane: eps_1' and, about an axis, eps_2'; linear fluid: pressure is -sxx
  std::vector<double> tx, ty;        // membrane: unit tangent t
  std::vector<double> dxx, dyy, dxy, dzz;  // eps' of this step, for laws that need their neighbours' new places first
  // F = dx / dX of laws that carry it, fxy = d x / d Y, and the stretch across the plane; empty where no law does
  std::vector<double> fxx, fxy, fyx, fyy, fzz;
  std::vector<std::uint8_t> pinned;
  std::vector<int> id;

  explicit Points(const Scene& scene);
  std::size_t size() const { return x.size(); }

  /// Calls visit(array) for each property.
  template <class Visit>
  void each_array(const Visit& visit) {
    for (auto* array : {&x,   &y,   &vx,  &vy,     &mass,   &volume, &vxx, &vyx, &vxy, &vyy, &sxx, &syy,
                        &sxy, &szz, &rho, &energy, &strain, &hoop,   &tx,  &ty,  &dxx, &dyy, &dxy, &dzz})
      visit(*array);
    if (!fxx.empty()) {
      for (auto* array : {&fxx, &fxy, &fyx, &fyy, &fzz}) visit(*array);
    }
    visit(pinned), visit(id);
  }
};

/// Sums over points at a node, mapped at the start of a step (3.15)-(3.18).
struct NodeSums {
  Pair momentum{}, force{};
  double m = 0, gas = 0;  // mass, and that of the gas where its density comes from the nodes
};

/// Solution of the momentum equation at a node: acceleration f / m and velocity (mv)^L / m (3.19), (3.20).
/// The quotients are taken at the node. The thesis' momentum form multiplies by N_i first so that a tiny m_i cancels;
/// in floating point the order is of no matter as long as nothing overflows, and N_i >= 1e-24 (Locator::edge).
struct NodeMotion {
  Pair a{}, u{};
};

/// What the gas reads at a node: its density there, and the heat per mass that the ledger gives it.
struct NodeGas {
  double rho = 0, heat = 0;
};

/// What points gave to ghosts, to their images; the ghosts are empty then.
void fold_sums(const Frame& frame, std::vector<NodeSums>& sums);

/// The background grid's fields, and the lists of cells and nodes that hold points: nothing else is touched in a step.
/// By splines a "cell" is what lies nearest to a node. Ghosts are no active nodes: what they hold is folded at once.
struct Grid {
  Frame frame;
  std::vector<NodeSums> sums;
  std::vector<NodeMotion> motion;
  std::vector<Pair> convected;  // (3.24): first sum m v N, then divided by m; by usf the velocity before the solve
  std::vector<NodeGas> gas;     // where the gas takes its density from the nodes
  std::vector<double> loss;     // where the ledger is kept: energy that the gas takes in the next step [energy]
  std::vector<double> squares;  // where the ledger is kept: |v|^2 before the solve plus after it
  std::vector<int> active_cells, active_nodes;
  std::vector<std::uint32_t> cell_stamp, node_stamp;  // the list in which a cell or node stands already
  std::uint32_t stamp = 0;

  Grid(const Scene& scene);
  /// Lists the cells that hold points, and their nodes. The places must lie inside the frame.
  template <class Kernel>
  void list_active(const Points& points);

  // What points gave to ghosts, to their images; the ghosts are empty then.
  void fold_sums() { mpm::fold_sums(frame, sums); }
  void fold_convected();
  // What points read at ghosts.
  void unfold_motion();
  void unfold_convected();
  void fold_loss();
  void unfold_gas();
  void unfold_squares();
};

}  // namespace tether::mpm
