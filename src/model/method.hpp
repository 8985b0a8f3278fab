// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "base/words.hpp"

namespace tether {

/// When stress is updated in a step: after the new velocities were mapped back (musl, the thesis'), first, or last.
enum class StressOrder { musl, usf, usl };
template <>
inline constexpr std::array<Word<StressOrder>, 3> words<StressOrder>{
    {{StressOrder::musl, "musl"}, {StressOrder::usf, "usf"}, {StressOrder::usl, "usl"}}};
/// Shape functions between points and nodes: bilinear over a cell (A.3.1), or quadratic B-splines at the nodes.
enum class Kernel { linear, bspline };
template <>
inline constexpr std::array<Word<Kernel>, 2> words<Kernel>{{{Kernel::linear, "linear"}, {Kernel::bspline, "bspline"}}};
/// What a point takes from the nodes: an increment of its velocity, or a velocity field that is linear about it.
enum class Transfer { flip, apic };
template <>
inline constexpr std::array<Word<Transfer>, 2> words<Transfer>{{{Transfer::flip, "flip"}, {Transfer::apic, "apic"}}};
/// Velocity gradient that heats the gas: the one that updates the stress, or that of (v_old + v_new)/2 after the solve.
enum class GasEnergy { rate, centred };
template <>
inline constexpr std::array<Word<GasEnergy>, 2> words<GasEnergy>{
    {{GasEnergy::rate, "rate"}, {GasEnergy::centred, "centred"}}};
/// Bodies at a node move in one field; or by the criteria of A.1.3; or by an impulse where their points touch.
enum class ContactRule { none, release, gap };
template <>
inline constexpr std::array<Word<ContactRule>, 3> words<ContactRule>{
    {{ContactRule::none, "none"}, {ContactRule::release, "release"}, {ContactRule::gap, "gap"}}};
/// What a membrane's strain is measured by: the points' strain rates (5.2), or the distance to the next point.
enum class MembraneStrain { point, element };
template <>
inline constexpr std::array<Word<MembraneStrain>, 2> words<MembraneStrain>{
    {{MembraneStrain::point, "point"}, {MembraneStrain::element, "element"}}};
/// Where a membrane's normals come from (chapter 7).
enum class NormalRule { connectivity, color, quadratic, cubic, mass_linear, mass_quadratic };
template <>
inline constexpr std::array<Word<NormalRule>, 6> words<NormalRule>{{{NormalRule::connectivity, "connectivity"},
                                                                    {NormalRule::color, "color"},
                                                                    {NormalRule::quadratic, "quadratic"},
                                                                    {NormalRule::cubic, "cubic"},
                                                                    {NormalRule::mass_linear, "mass-linear"},
                                                                    {NormalRule::mass_quadratic, "mass-quadratic"}}};
/// The points that share a mass matrix (7.12): those of a cell, or of the whole membrane.
enum class MatrixScope { cell, membrane };
template <>
inline constexpr std::array<Word<MatrixScope>, 2> words<MatrixScope>{
    {{MatrixScope::cell, "cell"}, {MatrixScope::membrane, "membrane"}}};
/// A cell with one membrane point (7.8): four cells together (Fig. 88), or the normal of the step before.
enum class LonePoint { ghost, previous };
template <>
inline constexpr std::array<Word<LonePoint>, 2> words<LonePoint>{
    {{LonePoint::ghost, "ghost"}, {LonePoint::previous, "previous"}}};

/// How a scene is to be computed: the set of $mpm method, or what the deck says of single parts.
struct Method {
  StressOrder order = StressOrder::musl;
  Kernel kernel = Kernel::linear;
  Transfer transfer = Transfer::flip;
  GasEnergy gas_energy = GasEnergy::rate;
  ContactRule contact = ContactRule::none;
  int criterion = 1;  // 1 (9.7), 2 (9.8), 3 (9.9)
  MembraneStrain membrane_strain = MembraneStrain::point;
  NormalRule normals = NormalRule::connectivity;
  MatrixScope matrix = MatrixScope::cell;
  LonePoint lone_point = LonePoint::ghost;
  bool ledger = false;   // what the transfer loses heats the gas
  bool jaumann = false;  // the stress of solids turns with them
};

/// What an edge of the grid does with gas: what its wall code says, or gas passes through it.
enum class EdgeKind { wall, outflow, inflow };
template <>
inline constexpr std::array<Word<EdgeKind>, 3> words<EdgeKind>{
    {{EdgeKind::wall, "wall"}, {EdgeKind::outflow, "outflow"}, {EdgeKind::inflow, "inflow"}}};

/// Cells beyond an open edge that hold gas: a strip that gives the nodes at the edge whole masses and pressures.
constexpr int strip_cells = 6;

/// An edge and the gas outside it, at an outflow only where the deck gives it.
struct Edge {
  EdgeKind kind = EdgeKind::wall;
  bool has_outside = false;
  double density = 0, energy = 0;  // outside [mass/volume], [energy/mass]
  double u = 0, v = 0;             // outside, in x and y [velocity]
  std::size_t body = 0;            // which gas comes in at an inflow

  bool open() const { return kind != EdgeKind::wall; }
};

/// Left, right, bottom, top: the order of wl, wr, wb, wt.
struct Edges {
  std::array<Edge, 4> of{};

  bool any() const { return of[0].open() || of[1].open() || of[2].open() || of[3].open(); }
};

constexpr std::array<const char*, 4> edge_names{"left", "right", "bottom", "top"};

/// Where a watched number is doubtful, and where it ends the run; 0 switches either off.
struct Limit {
  double warn = 0, stop = 0;
};

/// What a run that goes wrong is known by, as the deck's group $limits describes it; without a deck all are off.
struct Limits {
  Limit quality;      ///< least volume of an element over that at the start: below
  Limit volume;       ///< a body's volume over that at the start, or the other way round: below
  Limit energy_step;  ///< rise of the energy that nothing booked explains, from one look to the next, over the largest
                      ///< energy before or exchanged meanwhile: above
  Limit energy_growth;  ///< the same since the start: warns above a part of the largest energy exchanged, stops above a
                        ///< multiple of the energy at the start, or of what was booked or fell since
  Limit splitting;      ///< size of the mismatch of the power across the interface: above
  Limit cfl;            ///< cells that the fluid in a box crosses in a step: above
};

}  // namespace tether
