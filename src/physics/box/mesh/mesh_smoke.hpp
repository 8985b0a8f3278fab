// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "physics/box/mesh/mesh_velocity.hpp"

namespace tether::coupled {

/// Carries what is dissolved in a fluid from the cells of one mesh to those of the next, as the fluid moves in a time
/// h. Each new cell has the mean of what comes to places within it, within the extrema about where that was. What parts
/// of the fluid hold in sum, which that changes a little, is then what they held, with what came in less what went out:
/// a rest goes to where the extrema leave room for it, and only where they leave none beyond them (R. Bermejo, J. Conde
/// 2002). What is in one part never gets into another one. A part without new cells gives its contents to the nearest.
class ContentCarrier {
 public:
  /// All must outlive it. `v` are the velocities on the old mesh, free of divergence.
  ContentCarrier(const FlowMesh& old, const FaceValues& v, const MeshVelocity& velocity, const FlowMesh& next,
                 double h);

  struct Carried {
    std::vector<double> content;  ///< of each new cell
    double in = 0, out = 0;       ///< through entrances
  };
  /// Carries contents of the old cells. `entrances` are faces of the boundary that fluid goes through, with what comes
  /// in there by volume.
  Carried carry(std::span<const double> content, std::span<const FaceValue> entrances) const;

 private:
  /// Where what comes to a place in a new cell was.
  struct Source {
    Vec<3> x;
    std::size_t cell = 0;
    int face = -1;  ///< of the boundary that it came in through
  };
  /// The cells that hold what is carried from and to a part of the fluid.
  struct Part {
    double holds = 0, volume = 0;
    std::vector<std::size_t> cells;  ///< new ones
  };
  /// What a new cell gets, and within what.
  struct Means {
    std::vector<double> value, low, high;
  };

  void join_parts();
  double out_of(std::size_t face) const;
  Means means_of(const CellField& field, std::span<const double> entering) const;
  std::vector<Part> parts_of(std::span<const double> content, std::span<const double> gained) const;
  void give_away_lost(std::vector<Part>& parts) const;
  void pass_through(const CellField& field, std::span<const FaceValue> entrances, std::vector<double>& gained,
                    Carried& carried) const;
  void settle(const Part& part, const Means& means, std::vector<double>& content) const;

  const FlowMesh& old_;
  const FaceValues& v_;
  const MeshVelocity& velocity_;
  const FlowMesh& next_;
  double h_;
  std::vector<Source> source_;                           // dim + 1 of each new cell
  std::vector<std::size_t> part_of_old_, part_of_next_;  // of each region
  std::size_t parts_ = 0;
};

}  // namespace tether::coupled
