// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "physics/box/liquid/exits.hpp"
#include "physics/box/liquid/hats.hpp"
#include "physics/box/liquid/particles.hpp"
#include "physics/box/liquid/speed_limit.hpp"
#include "physics/box/placer.hpp"

namespace tether::liquid {

/// Kinetic energy and energy of gravity that come in and leave with liquid [energy].
struct CarriedEnergy {
  double in = 0, out = 0;
};

/// A liquid with a surface during a step: what is known of its particles on the grid. The scene and the team must
/// outlive it.
class LiquidOfStep {
 public:
  LiquidOfStep(const Coupled& scene, const Vec<3>& gravity, Team& team)
      : scene_(scene), gravity_(gravity), team_(team), inflow_(scene) {
    for (std::size_t side = 0; side < held_.size(); ++side)
      held_[side] = scene.viscosity > 0 && scene.sides[side] == BoxSide::wall;
  }

  /// Kinetic energy and energy of gravity of all particles [energy].
  double energy(const Particles& particles) const;
  /// Nothing has come in or left yet.
  LiquidFlow no_flow() const { return {0, 0, std::vector<double>(inflow_.jets(), 0.0)}; }

  /// Sorts the particles and finds what they fill, with what has come in and is none yet. Everything else asks this
  /// first.
  void look(const LiquidFlow& flow, Particles& particles);
  /// How much of each cell is filled.
  std::span<const double> filled() const { return filled_; }

  /// Gives the faces the particles' velocities.
  void give_to_faces(const coupled::FlowDomain& room, const Particles& particles, coupled::FaceValues& v);
  /// Gives faces about the liquid velocities, for particles that cross so many cells in a step.
  void extend(const coupled::Placement& at, double cells_crossed, coupled::FaceValues& v) const;
  /// Remembers how fast the liquid is before pressures act.
  void note_speeds(const coupled::FaceValues& v) { fastest_ = fastest_about(scene_.grid, v); }
  /// Particles take the faces' velocities, which forces and bodies can have made faster by `more` since, and go along
  /// with them for a time h; what leaves goes, and what jets bring comes. Returns the energy of both.
  CarriedEnergy carry(const coupled::Placement& at, const coupled::FaceValues& v, double more,
                      std::span<const double> jet_speeds, double h, Particles& particles, LiquidFlow& flow) const;

 private:
  const Coupled& scene_;
  Vec<3> gravity_;  // [acceleration]
  Team& team_;
  Inflow inflow_;
  HeldSides held_{};
  CellParticles cells_;
  std::vector<double> filled_, fastest_;
  coupled::FaceValues reached_;  // volume of the particles about each face
};

}  // namespace tether::liquid
