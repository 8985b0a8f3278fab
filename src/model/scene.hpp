// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/numbers.hpp"
#include "base/words.hpp"
#include "grid/boxes.hpp"
#include "laws/elastic.hpp"
#include "laws/material.hpp"
#include "laws/walls.hpp"
#include "model/method.hpp"
#include "model/physics.hpp"
#include "model/strip.hpp"

namespace tether {

/// Initial state of material points, one array a property, all of one length.
struct PointSet {
  std::vector<double> x, y;           // [length]
  std::vector<double> vx, vy;         // [velocity]
  std::vector<double> sxx, syy, sxy;  // initial stress [stress]
  std::vector<double> volume;         // [volume], per unit depth; the whole ring's about an axis
  std::vector<double> mass;           // [mass], likewise
  std::size_t size() const { return x.size(); }
};

/// Points first .. first + count - 1 of the scene's PointSet, all of one law and density.
struct Body {
  std::string name;
  Material material;
  double density = 0;          // [mass/volume], of the deck; a heavy point does not change it
  double specific_energy = 0;  // initial, of a gas [energy/mass]
  std::size_t first = 0, count = 0;
  bool closed = false;  // membrane: its last point is next to its first
  int lattice = 1;      // of a region: points along a side of a cell
};

struct Clock {
  double tmax = 0;   // [time]
  double tstep = 0;  // the deck's step, min(tstep, dtmax) [time]
  double cfl = 1;    // factor of the step limit; 0 takes the deck's step as it is
};

/// The exact solution to compare with, of src/reference.
enum class ReferenceKind { none, riemann, spring, string, pendulum, piston, radial_gas, thin_ring };
template <>
inline constexpr std::array<Word<ReferenceKind>, 7> words<ReferenceKind>{{{ReferenceKind::riemann, "riemann"},
                                                                          {ReferenceKind::spring, "spring"},
                                                                          {ReferenceKind::string, "string"},
                                                                          {ReferenceKind::pendulum, "pendulum"},
                                                                          {ReferenceKind::piston, "piston"},
                                                                          {ReferenceKind::radial_gas, "radial-gas"},
                                                                          {ReferenceKind::thin_ring, "thin-ring"}}};

/// Whether snapshots are written as VTK files, too: where they are not large, always, or never.
enum class VtkFiles { automatic, yes, no };
template <>
inline constexpr std::array<Word<VtkFiles>, 3> words<VtkFiles>{
    {{VtkFiles::automatic, "auto"}, {VtkFiles::yes, "yes"}, {VtkFiles::no, "no"}}};

/// Snapshots of more points, nodes or cells are written as VTK files only where the deck asks for them.
constexpr std::size_t most_in_vtk = 200000;
constexpr bool writes_vtk(VtkFiles wanted, std::size_t count) {
  return wanted == VtkFiles::yes || (wanted == VtkFiles::automatic && count <= most_in_vtk);
}

/// Intervals between outputs [time]; 0 where an output is off.
struct OutputIntervals {
  double history = 0, points = 0, grid = 0, checkpoint = 0;
  VtkFiles vtk = VtkFiles::automatic;
  bool tracked_angle = false;
};

/// What the user asked for, without a word on how it is computed: values only, no files, no deck, no solver.
struct Scene {
  std::string title;
  Physics physics;
  Units units = Units::none;
  BackgroundGrid grid;
  Geometry geometry = Geometry::plane;
  Walls walls;
  Edges edges;         // gas passes through some of them
  double gravity = 0;  // acceleration in y [length/time2]
  PointSet points;
  std::vector<Body> bodies;
  std::shared_ptr<const Strip> strip;     ///< whose rows of points run as one, where the user asked for it
  std::vector<std::size_t> tracked;       ///< points whose paths are recorded
  std::vector<std::string> tracked_from;  ///< of each how far it is from the place that was asked for, or nothing
  std::vector<std::size_t> pinned;        ///< points that a pin holds where they are
  double ambient = 0;                     ///< pressure outside membranes that enclose gas [stress]
  Clock clock;
  Method method;
  OutputIntervals outputs;
  Limits limits;
  ReferenceKind reference = ReferenceKind::none;
  std::optional<std::array<double, 2>> reference_window;  ///< part of a tube that is compared, from x to x [length]

  Path path() const { return path_of(physics); }
  /// Bodies on a mesh, or null where there are none.
  const Solids* solids() const { return solids_of(physics); }
  /// Returns what a physics alone has, or null where the scene is of another one.
  const Rigid* rigid() const { return part<RigidBody>(&RigidBody::rigid); }
  const Flow* flow() const { return part<MeshFlow>(&MeshFlow::flow); }
  const Coupled* coupled() const { return part<BoxFlow>(&BoxFlow::box); }

 private:
  template <class One, class Part>
  const Part* part(std::shared_ptr<const Part> One::*member) const {
    const One* one = std::get_if<One>(&physics);
    return one ? (one->*member).get() : nullptr;
  }
};

/// Returns the name that the history gives to tracked point k.
inline std::string tracked_name(const Scene& scene, std::size_t k) {
  return "point " + std::to_string(scene.tracked[k] + 1) + (k < scene.tracked_from.size() ? scene.tracked_from[k] : "");
}

/// Returns whether a pin holds the point where it is.
inline bool is_pinned(const Scene& scene, std::size_t point) {
  return std::find(scene.pinned.begin(), scene.pinned.end(), point) != scene.pinned.end();
}

/// The first body of a law, or null.
template <class Law>
const Body* find_body(const Scene& scene) {
  for (const Body& body : scene.bodies) {
    if (std::holds_alternative<Law>(body.material)) return &body;
  }
  return nullptr;
}

/// Returns whether a body is elastic and fills a region.
inline bool has_solid(const Scene& scene) {
  return std::ranges::any_of(scene.bodies, [](const Body& body) { return is_solid(body.material); });
}

/// Returns whether bodies are there that do not share one field anyway, and between which contact may act.
inline bool may_touch(const Scene& scene) { return scene.bodies.size() > 1 && has_solid(scene); }

}  // namespace tether
