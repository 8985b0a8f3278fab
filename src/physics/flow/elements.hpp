// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "algebra/sparse_matrix.hpp"
#include "base/team.hpp"
#include "base/vec.hpp"
#include "grid/shapes.hpp"
#include "model/flow.hpp"
#include "physics/flow/unknowns.hpp"

namespace tether::fem {

/// What the equations of one step are about: velocities v0 at its start, v1 at its end, 2 numbers a node, which act as
/// v_t = (1 - theta) v0 + theta v1; the pressure p in between, 1 number a node. Of steady flows the rate is 0.
struct FlowMoment {
  std::span<const double> v0, v1, p;
  double theta = 0.5;
  double rate = 0;                       ///< 1/dt [1/time]
  double viscosity = 0;                  ///< mu [stress time]
  std::span<const double> acceleration;  ///< of body forces, 2 numbers a point of quadrature [length/time2]
  Linearisation linearisation = Linearisation::newton;
  double gravity = 0;  ///< along y, of the fluid beyond open sides; 0 where there is none [length/time2]
};

/// Sizes that a residual is measured against: of the elements' forces and fluxes before they balance each other, and of
/// what rounding may leave of either.
struct FlowScale {
  double force = 0, flux = 0, force_rounding = 0, flux_rounding = 0;
};

/// What goes through a flow's boundary and is lost inside [energy/time].
struct FlowPower {
  double carried_by_open = 0;     ///< kinetic energy out through open sides
  double carried_by_inflows = 0;  ///< and through inflows, negative where they bring some
  double convected = 0;           ///< what the convective term takes: that, but for what the divergence makes it lose
  double open_traction = 0;       ///< of the stress that open sides leave, and of the pressure outside
  double dissipated = 0;          ///< 2 mu e : e
  double stabilised = 0;          ///< what SUPG, PSPG and LSIC take, which vanishes with the size of the elements
  double expansion = 0;           ///< -p div v_t of elements that nothing stabilises
  double body = 0;                ///< of body forces
};

/// A force on the fluid at a node [force].
struct NodeForce {
  std::size_t node = 0;
  Vec<2> force{};
};

/// The elements of a flow: integrals over its mesh, and over its sides.
class FlowElements {
 public:
  virtual ~FlowElements() = default;

  /// Adds the residual of momentum (45) to f, 2 numbers a node [force], and of incompressibility (46) to g, 1 number a
  /// node [volume/time]; of twins to the node whose unknowns they share. At prescribed nodes f is the force of the wall
  /// on the fluid.
  virtual FlowScale add_residual(const FlowMoment& m, std::span<double> f, std::span<double> g) const = 0;
  /// Adds the residual's derivative by the unknowns.
  virtual void add_tangent(const FlowMoment& m, const ClusterPattern& pattern, SparseMatrix& K) const = 0;
  /// The body force's acceleration at all points of quadrature, with that of gravity along y [length/time2].
  virtual std::vector<double> accelerations(double gravity, double time) const = 0;
  virtual double kinetic_energy(std::span<const double> v) const = 0;   ///< [energy]
  virtual double pressure_energy(std::span<const double> p) const = 0;  ///< the pressure's size times volume [energy]
  /// Mass, and momentum in x and y.
  virtual std::array<double, 3> momentum(std::span<const double> v) const = 0;
  virtual FlowPower power(const FlowMoment& m) const = 0;
  /// At nodes where the flow's force side k meets other walls: half of what the stress on these gives to the nodes less
  /// half of what that on the side itself gives.
  virtual std::vector<NodeForce> corner_forces(const FlowMoment& m, std::size_t k) const = 0;
  /// The fluid's stress at a place s of the reference element of element e: xx, yy, xy [stress].
  virtual std::array<double, 3> stress_at(const FlowMoment& m, std::size_t e, const Vec<2>& s) const = 0;
  /// dv/dx - du/dy, the mean around each node [1/time].
  virtual std::vector<double> vorticity(std::span<const double> v) const = 0;
  /// <grad N_A, grad N_B> of the velocity's functions, and <grad N_A, (-v, u)>: the stream function's equations. Nodes
  /// that have one number from 0 in `unknown` share a row and a column.
  virtual SparseMatrix laplacian(std::span<const int> unknown) const = 0;
  virtual std::vector<double> stream_source(std::span<const double> v) const = 0;
  /// <P_q, P_s> [volume] and <grad P_q, grad P_s> [volume/length2] of the pressures that are unknown, in the order of
  /// the unknowns; at open sides the second has rows and columns of the identity.
  virtual SparseMatrix pressure_mass() const = 0;
  virtual SparseMatrix pressure_laplacian() const = 0;
  /// The mean of tau_L, the weight of LSIC's <div v, div w>, or 0 where nothing stabilises [stress time].
  virtual double mean_lsic(const FlowMoment& m) const = 0;
  /// The pressure at all nodes: between those that have one as its functions are.
  virtual std::vector<double> pressure_at_nodes(std::span<const double> p) const = 0;
};

/// Calls f with the functions of a fluid's element (quad4 or quad9) at a place s of the reference element.
template <class Function>
void with_values_at(ElementKind kind, const Vec<2>& s, const Function& f) {
  if (kind == ElementKind::quad4)
    f(ShapesOf<ElementKind::quad4>::values(s));
  else
    f(ShapesOf<ElementKind::quad9>::values(s));
}

}  // namespace tether::fem
