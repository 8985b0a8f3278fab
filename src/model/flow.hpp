// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "base/expression.hpp"
#include "base/vec.hpp"
#include "base/words.hpp"
#include "grid/mesh.hpp"
#include "model/solids.hpp"

namespace tether {

/// How linear systems are solved: as their size asks, by factors, or by an iteration.
enum class Systems { automatic, direct, krylov };
template <>
inline constexpr std::array<Word<Systems>, 3> words<Systems>{
    {{Systems::automatic, "auto"}, {Systems::direct, "direct"}, {Systems::krylov, "krylov"}}};

/// Bilinear velocity and pressure, stabilised; or biquadratic velocity with bilinear pressure (Taylor and Hood).
enum class FlowElement { q1q1, q2q1 };
template <>
inline constexpr std::array<Word<FlowElement>, 2> words<FlowElement>{
    {{FlowElement::q1q1, "q1q1"}, {FlowElement::q2q1, "q2q1"}}};

/// How a flow goes on in time: the mid-point rule (47), backward Euler, or no dynamics: each step is a steady flow.
enum class FlowIntegrator { midpoint, euler, steady };
template <>
inline constexpr std::array<Word<FlowIntegrator>, 2> words<FlowIntegrator>{
    {{FlowIntegrator::midpoint, "midpoint"}, {FlowIntegrator::euler, "euler"}}};

/// What a correction takes of the convective term's derivative: all of it, or the part that carries the velocity along.
enum class Linearisation { newton, picard };
template <>
inline constexpr std::array<Word<Linearisation>, 2> words<Linearisation>{
    {{Linearisation::newton, "newton"}, {Linearisation::picard, "picard"}}};

/// What a side of the fluid's boundary does.
enum class Boundary { no_slip, slip, moving, inflow, open, periodic };
template <>
inline constexpr std::array<Word<Boundary>, 6> words<Boundary>{{{Boundary::no_slip, "no-slip"},
                                                                {Boundary::slip, "slip"},
                                                                {Boundary::moving, "moving"},
                                                                {Boundary::inflow, "inflow"},
                                                                {Boundary::open, "open"},
                                                                {Boundary::periodic, "periodic"}}};

/// A plane vector that may change in place and time: an expression in x, y, t for each component, null for 0, times a
/// factor over time.
struct FlowVector {
  std::array<std::shared_ptr<const Expression>, 2> component{};
  Amplitude factor;
  /// Throws RunError where an expression has no finite value.
  Vec<2> at(double x, double y, double t) const;
  /// Returns whether it is zero by the deck's word.
  bool absent() const { return !component[0] && !component[1]; }
};

/// Part of the boundary with its condition. Of `periodic` the nodes say the rest (Flow::twin).
struct FlowSide {
  std::string name;
  Boundary boundary = Boundary::no_slip;
  Sides sides;
  FlowVector velocity;  ///< prescribed on moving walls and inflows
  int number = 0;       ///< of the deck's boundary_on, from 1; 0 of the sides that the deck does not name
};

/// What a force is recorded of, and its torque about a centre: sides of the fluid's boundary, immersed bodies and sides
/// of these, together.
struct ForceSide {
  std::string name;
  Sides sides;
  Vec<2> centre{};               // [length]
  std::vector<int> bodies = {};  ///< regions of the solids, from 0
  Sides body_sides = {};         ///< of the solids' mesh
};

/// A rectangle of tracers, nx x ny of them at the middles of its equal parts, that go with the fluid from the start.
struct TracerGrid {
  std::array<int, 2> count{};  // along x and y; 0: none
  Box<2> box;                  // [length]
};

/// An incompressible Newtonian fluid on a plane mesh that stays where it is, as the deck's groups $mesh and $flow
/// describe it (2.3).
struct Flow {
  Mesh mesh;  ///< quad4 for q1q1, quad9 for q2q1
  FlowElement element = FlowElement::q2q1;
  double stabilisation = 1;  ///< factor of tau and tau_L of q1q1; 0 takes them out
  double density = 0;        // [mass/volume]
  double viscosity = 0;      // mu [stress time]
  /// All of the boundary, each part once. Where sides meet, a node belongs to the wall at rest before the moving wall
  /// before the inflow; slip holds what these leave.
  std::vector<FlowSide> sides;
  std::vector<int> twin;      ///< of each node the one whose unknowns it shares, itself but on periodic sides
  FlowVector acceleration;    ///< of the deck's body force [length/time2]; gravity is the scene's
  bool fluid_outside = true;  ///< beyond open sides, at rest, whose pressure grows with the depth; or nothing
  double level = 0;           ///< height at which that pressure is zero [length]
  FlowVector start;           ///< velocity at the start
  FlowIntegrator integrator = FlowIntegrator::midpoint;
  Linearisation linearisation = Linearisation::newton;
  Systems systems = Systems::automatic;
  double tolerance = 1e-6;       ///< of Newton's method: residual over the largest force
  double speed = 0, length = 0;  ///< of the Reynolds number and of drag and lift coefficients; 0: not given
  std::vector<ForceSide> forces;
  std::vector<Vec<2>> probes;                   ///< places in the mesh where the flow is recorded [length]
  std::vector<std::array<int, 2>> differences;  ///< of the pressures at two of them, from 0
  TracerGrid tracers;
  std::vector<double> volume_penalty;  ///< of each region of the solids, 0 for none [stress]
  std::vector<bool> volume_by_fluid;   ///< of each, whether the fluid's pressure holds its volume, or its own law
};

/// Unknowns: two velocities a node, a pressure a corner, as if no side held any.
double unknowns_of(const Flow& flow);

/// Returns whether any immersed body has a law of its own for its volume: the fluid's pressure is outside of it alone,
/// and where no side is open, its level is that at which such bodies together keep their volume.
bool any_own_volume(const Flow& flow);

/// Says of each region of the solids whether it is lighter than the fluid. The fluid carries all nodes of such a
/// region: what the region takes of the fluid's mass is then no more than the velocities there have. Nodes that follow
/// others would exceed it.
std::vector<bool> lighter_regions(const Flow& flow, const Solids& solids);

/// More unknowns than these are solved by GMRES where the deck leaves it open.
constexpr double most_unknowns_of_factors = 2e5;

/// Which of direct and krylov is taken. Steady flows and flows with immersed solids are left to factors, as GMRES takes
/// many iterations for them or does not get there.
Systems systems_of(const Flow& flow, bool with_solids);

/// For each node the side that prescribes its velocity, walls at rest before moving walls before inflows, and the node
/// of that side whose place counts, itself but for twins; -1 where none does.
struct Holder {
  int side = -1, node = -1;
};
std::vector<Holder> holders_of(const Flow& flow);

}  // namespace tether
