// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/numbers.hpp"
#include "grid/boxes.hpp"
#include "model/coupled.hpp"

namespace tether {
class SideFaces;
}

namespace tether::coupled {

/// What a cell holds. Fluid cells have a pressure; in void ones it is zero.
enum class CellKind : std::uint8_t { fluid, solid, wall, empty };

/// What a face does: its velocity is found with the pressure; or is prescribed by a wall or a jet; or a solid closes
/// it.
enum class FaceKind : std::uint8_t { open, prescribed, closed };

/// A number for each face, by axis.
using FaceValues = std::array<std::vector<double>, 3>;

FaceValues face_values(const StaggeredGrid& grid, double value = 0);

/// Where fluid is and which faces it goes through, during one step.
struct FlowDomain {
  StaggeredGrid grid;
  std::vector<CellKind> kind;                 ///< of each cell
  std::array<std::vector<FaceKind>, 3> face;  ///< of each face
  FaceValues area;                            ///< open area of each face; 0 where closed [area]
  FaceValues volume;                          ///< of the fluid that an open face's velocity moves [volume]
  std::vector<int> region;                    ///< of each fluid cell, from 0: cells that open faces join; else -1
  int regions = 0;
  std::array<bool, 6> slips{};                       ///< sides of the box that a viscous fluid slips along
  std::shared_ptr<const SideFaces> sides = nullptr;  ///< what the box's sides are where no solid is; null: no openings
};

/// Cells on the two sides of a face across the axis, lower first; -1 outside the box.
inline std::array<int, 2> cells_beside(const StaggeredGrid& grid, int axis, std::size_t face) {
  const std::size_t stride = grid.stride(axis), faces = at(grid.n[at(axis)] + 1), row = face / stride;
  const std::size_t layer = row / faces, i = row - layer * faces;  // faces have one place more along the axis
  const int upper = static_cast<int>(face - layer * stride);
  return {i == 0 ? -1 : upper - static_cast<int>(stride), i + 1 == faces ? -1 : upper};
}

}  // namespace tether::coupled

namespace tether::coupled {

/// Smoke and warmth of each cell as the scene has them at the start.
struct FirstSmoke {
  std::vector<double> density, temperature;
};
FirstSmoke first_smoke(const Coupled& scene);

/// The fluid beyond the open sides of the box. It is at rest, so that it lies in layers: at each height it holds the
/// smoke and the warmth that the start has there if all cells of that height have the same, and none elsewhere. Its
/// pressure is zero at the scene's level and grows downwards by what lies above, as it does between the cells' middles
/// of a box at rest: fluid that is at rest at the start stays so to the last digits. Beyond sides of the kind `empty`
/// there is nothing and no pressure.
class Outside {
 public:
  /// The scene must outlive it. Along y `gravity` makes the pressure outside; across it there is none [acceleration].
  Outside(const Coupled& scene, const Vec<3>& gravity);

  /// Returns the pressure of the fluid outside at a height [stress].
  double pressure(double y) const;
  /// Returns what fluid at rest has at a place, but for a constant [stress].
  double at_rest(const Vec<3>& x) const;
  /// Returns whether there is fluid beyond a side of the box: beyond that of a liquid with a surface is air.
  bool presses(int side) const { return has_fluid_beyond(scene_, side) && !scene_.cavities_only && !scene_.liquid; }
  /// The pressure beyond a side of the box at a height: zero where the side is no open one, or has nothing beyond.
  double pressure_beyond(int side, double y) const;
  /// Smoke and warmth of the layer at a row of cells.
  double density(int row) const { return density_[static_cast<std::size_t>(row)]; }
  double temperature(int row) const { return temperature_[static_cast<std::size_t>(row)]; }
  /// Returns whether any layer has some.
  bool has_smoke() const;

  /// Adds to the velocities of the open sides' faces what the pressure outside does to them in a time `h`.
  void press(const FlowDomain& domain, double h, FaceValues& v) const;
  /// The power that the pressure outside gives the fluid at velocities v [power].
  double power(const FlowDomain& domain, const FaceValues& v) const;

 private:
  template <class Function>
  void each_face(const FlowDomain& domain, const Function& f) const;
  double lifted(double y) const;

  const Coupled& scene_;
  Vec<3> gravity_;
  std::vector<double> density_, temperature_;  // of each row of cells
  std::vector<double> place_, lifted_;         // heights, and the integral of what smoke does up to them
};

/// Calls f(face) for the faces of a side of the box, numbers of those across the side's axis.
template <class Function>
void each_face_of_side(const StaggeredGrid& grid, int side, const Function& f) {
  const auto a = static_cast<std::size_t>(axis_of_side(side));
  auto end = grid.faces(axis_of_side(side)), face = end;
  std::array<int, 3> first{};
  first[a] = is_low_side(side) ? 0 : grid.n[a];
  end[a] = first[a] + 1;
  for (face[2] = first[2]; face[2] < end[2]; ++face[2]) {
    for (face[1] = first[1]; face[1] < end[1]; ++face[1]) {
      for (face[0] = first[0]; face[0] < end[0]; ++face[0]) f(grid.face(axis_of_side(side), face));
    }
  }
}

}  // namespace tether::coupled
