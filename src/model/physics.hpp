// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <variant>

namespace tether {

/// The methods that can run a scene: material points, finite elements, fluid and solids on a regular grid.
enum class Path { mpm, fem, coupled };

/// The word for it on the command line and in summary.txt.
constexpr const char* path_name(Path path) { return path == Path::mpm ? "mpm" : path == Path::fem ? "fem" : "coupled"; }

struct Solids;
struct Rigid;
struct Flow;
struct Coupled;

// What a scene can be, one struct each. Whoever asks which one it is uses std::visit, so that a new one does not
// compile before it is handled everywhere. Meshes and boxes are shared: a copy of a scene has the same ones.

/// Points that carry mass over a background grid; they are the scene's points and bodies.
struct MaterialPoints {
  static constexpr Path path = Path::mpm;
};

/// Strings of the scene's points, as explicit bars from point to point.
struct Bars {
  static constexpr Path path = Path::fem;
};

/// Elastic bodies on a mesh.
struct ElasticBodies {
  static constexpr Path path = Path::fem;
  std::shared_ptr<const Solids> solids;
};

/// One rigid body, whose mesh gives it its mass and its shape.
struct RigidBody {
  static constexpr Path path = Path::fem;
  std::shared_ptr<const Solids> solids;
  std::shared_ptr<const Rigid> rigid;
};

/// A fluid on a mesh; its solids are immersed in it, and null where there are none.
struct MeshFlow {
  static constexpr Path path = Path::fem;
  std::shared_ptr<const Solids> solids;
  std::shared_ptr<const Flow> flow;
};

/// A fluid in a box; its solids go through it, and are null where there are none.
struct BoxFlow {
  static constexpr Path path = Path::coupled;
  std::shared_ptr<const Solids> solids;
  std::shared_ptr<const Coupled> box;
};

using Physics = std::variant<MaterialPoints, Bars, ElasticBodies, RigidBody, MeshFlow, BoxFlow>;

inline Path path_of(const Physics& physics) {
  return std::visit([](const auto& one) { return one.path; }, physics);
}

/// The solids of a physics that has some; null else.
const Solids* solids_of(const Physics& physics);
/// Sets the solids of a physics that can have some, which MaterialPoints and Bars cannot.
void set_solids(Physics& physics, std::shared_ptr<const Solids> solids);

}  // namespace tether
