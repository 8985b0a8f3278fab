// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "physics/box/friction/near_surface.hpp"
#include "physics/box/friction/unknowns.hpp"
#include "physics/box/outside.hpp"

namespace tether::coupled {

/// The solids about a fluid that rubs: bodies, and obstacles that cut cells.
struct SolidsNearFaces {
  const SolidSurface& surface;  ///< of both; nodes of obstacles come after those of bodies
  const SurfaceNearFaces& crossings;
  std::size_t moving = 0;     ///< numbers of the bodies' nodes
  bool bodies_stick = false;  ///< whether the fluid sticks to bodies; to obstacles it does
};

/// A surface that is nearer than that counts as so far [cells].
constexpr double nearest_surface = 1e-2;

/// The slope of a velocity along an axis, in a quarter of what lies about an edge of the cells.
struct Slope {
  enum class Kind {
    fluid,   ///< of the fluid there
    solid,   ///< of the solid that is there, which a slope of the other velocity goes along with
    free,    ///< none: nothing is exchanged there, and no shear stress acts
    outside  ///< of the fluid beyond an open side of the box
  };
  Kind kind = Kind::free;
  double part = 0;   ///< how much of the quarter has it; more than 1 where a surface lies beyond the quarter
  Combination rate;  ///< [1/time]
};

/// Slopes of velocities between the middles of faces, one-sided where a wall or a solid is nearer: there the velocity
/// is linear from a face's middle to the surface, whose velocity it has (F. Gibou et al., J. Comput. Phys. 176 (2002)
/// 205-227, hold a value at such a place alike: of order 2 in the velocity). All arguments must outlive it.
class Slopes {
 public:
  Slopes(const FlowDomain& domain, const FrictionUnknowns& unknowns, const SolidsNearFaces* solids);

  /// Returns whether a face's middle lies in a solid that the fluid sticks to: what fluid the face has is at its
  /// surface. `rate` gets how fast it slips, over the least distance that counts.
  bool is_attached(int axis, const std::array<int, 3>& face, Combination* rate = nullptr) const;
  /// Returns whether a face has a velocity of its own, unknown or prescribed.
  bool has_fluid(int axis, const std::array<int, 3>& face) const;

  /// Slope along b of the velocity across a, from a face towards the next one, as the way through `way` leads, a face
  /// across b.
  Slope across(int a, const std::array<int, 3>& face, int b, bool up, const std::array<int, 3>& way) const;
  /// Slopes along a of the velocity across a in a cell: one, or one on each side of a solid in between. Their parts are
  /// those of the cell.
  std::array<Slope, 2> ahead(int a, const std::array<int, 3>& cell) const;
  /// Returns whether the slope along b between a face and the one after it is that of the fluid all the way.
  bool is_whole(int a, const std::array<int, 3>& face, int b) const;
  /// How much of a face's box is fluid; 1 where no solids are.
  double part(int axis, const std::array<int, 3>& face) const;

 private:
  FaceKind kind(int axis, const std::array<int, 3>& face) const {
    return domain_.face[at(axis)][grid_.face(axis, face)];
  }
  bool is_face(int axis, const std::array<int, 3>& face) const;
  bool sticks(const SurfaceNear& near) const;
  void add_velocity(int axis, const SurfaceNear& near, double by, Combination& rate) const;
  Slope to_surface(int a, const std::array<int, 3>& face, int b, bool up, const SurfaceNear& near) const;
  Slope to_next(int a, const std::array<int, 3>& face, int b, bool up) const;
  Slope within_solid(int a, const std::array<int, 3>& face, int b, bool up, const std::array<int, 3>& way) const;
  std::optional<SurfaceNear> surface_at(int axis, const std::array<int, 3>& face) const;

  const FlowDomain& domain_;
  const StaggeredGrid& grid_;
  const FrictionUnknowns& unknowns_;
  const SolidsNearFaces* solids_;
  std::vector<NearSurface> near_;  // of each axis, where there are solids
};

}  // namespace tether::coupled
