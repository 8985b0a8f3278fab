// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/coupled.hpp"
#include "physics/box/liquid/particles.hpp"
#include "physics/box/outside.hpp"

namespace tether::liquid {

// How liquid comes into the box, and leaves it.

/// What has come into the box and left it since the start.
struct LiquidFlow {
  double in = 0, out = 0;    ///< [volume]
  std::vector<double> owed;  ///< of each jet: how far fluid came in since its last particles did [length]
};

/// The faces in the box's sides through which particles leave: open ones, and those where a jet takes fluid out.
class Exits {
 public:
  Exits(const coupled::FlowDomain& room, const coupled::FaceValues& v);

  /// Returns whether one leaves by a side of a cell, 2 axis for the lower one, 2 axis + 1 for the upper.
  bool lead_out(const std::array<int, 3>& cell, int side) const {
    const std::size_t axis = static_cast<std::size_t>(side / 2);
    if (exit_[axis].empty()) return false;
    auto face = cell;
    face[axis] += side % 2;
    return exit_[axis][grid_.face(static_cast<int>(axis), face)] != 0;
  }

 private:
  const StaggeredGrid& grid_;
  std::array<std::vector<std::uint8_t>, 3> exit_;  // of each face; empty where an axis has none
};

/// Takes the marked particles away, and returns their volume.
double remove_marked(std::span<const std::uint8_t> marked, Particles& particles);

/// Brings in what jets blow in.
class Inflow {
 public:
  explicit Inflow(const Coupled& scene) : scene_(scene) {}

  /// How many jets there are.
  std::size_t jets() const { return scene_.jets.size(); }
  /// Adds particles before the sides, that jets have brought in at these speeds in a time h: layer after layer, as far
  /// apart as those of a cell that is filled, all over the part of the side that is the jet's. Returns their volume.
  double blow_in(std::span<const double> speeds, double h, std::span<double> owed, Particles& particles) const;
  /// Returns what has come in and is no particle yet, as particles before the sides.
  Particles not_yet_in(std::span<const double> owed) const;

 private:
  double add_layer(std::size_t jet, double depth, double thickness, double speed, Particles& particles) const;

  const Coupled& scene_;
};

}  // namespace tether::liquid
