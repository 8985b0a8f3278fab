// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

}  // namespace tether
