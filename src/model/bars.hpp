// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "laws/walls.hpp"
#include "model/scene.hpp"

namespace tether {

/// Part of a spacing within which a string's end stands at a wall. A curve that begins at a wall has its first point
/// half a spacing from it, and the bar to the wall is what lies between. A point that stands nearer is the anchor: the
/// spring of thesis 5.5 has its first one 0.3 from the wall and counts its length L from there.
constexpr double held_within = 0.4;

/// Two nodes and what is between them. Its strain is the change of its length over the length at the start, and what
/// the points' stress at the start says: l / rest - 1 + strain.
struct Bar {
  std::size_t a = 0, b = 0;  ///< nodes: points of the scene, and after these the anchors
  double rest = 0;           ///< length at the start [length]
  double section = 0;        ///< its area [length2], per unit depth a thickness
  double strain = 0;         ///< at the start, number
  double E = 0;              ///< [stress]
  bool one_way = true;       ///< carries no compression
  /// Force over change of length while it carries [force/length].
  double stiffness() const { return E * section / rest; }
};

/// A node on a wall, to which a string's end is joined. At a wall that holds what is across it alone, it slides along.
struct Anchor {
  std::size_t point = 0;             ///< the string's end
  double x = 0, y = 0;               ///< where it stands at the start [length]
  std::uint8_t slides = holds_none;  ///< axis along which it goes with its point: holds_x, holds_y, or none
};

/// What a wall does with a string's end.
struct WallEnd {
  std::size_t point = 0;
  std::string wall;   ///< left, right, bottom, top
  double length = 0;  ///< of the bar to the wall; 0 where the point itself is held [length]
  bool slides = false;
};

/// The strings of a scene as two-node bars between consecutive points. Source: the comparison code of thesis 5.7.
struct BarMesh {
  std::vector<Bar> bars;
  std::vector<Anchor> anchors;
  std::vector<std::uint8_t> held;  ///< of each point: axis bits of what pins and walls hold
  std::vector<WallEnd> wall_ends;
};

/// Bars of all membranes of the scene: a bar's section is the mean of its points' volumes over their spacings, its
/// initial strain the mean of its points' initial stresses over E. An end that would meet a wall on less than another
/// spacing straight on is held there, or joined to it by a bar.
BarMesh bars_of(const Scene& scene);

/// Bound of the highest frequency of the bars with the points' masses, exact for one bar alone [1/time]; 0 where
/// nothing can move. The share k_e / sum k of a node's mass goes to each of its bars, and no frequency of a whole is
/// above the highest one of its parts (Irons): omega^2 = max over bars of S_a / m_a + S_b / m_b, S = sum k at a node.
double highest_frequency(const Scene& scene, const BarMesh& mesh);

/// Where a string's first end is held.
struct HeldEnd {
  double x = 0, y = 0;  // [length]
  bool slides = false;  ///< along the wall that holds it
};

/// The pin of the string's first point, or the place where the line of its first two points meets a wall that holds
/// what is across it. Material points feel a wall from the cell beside it, and what is between the wall and the first
/// point stretches with that cell: the string begins at the wall. Bars say themselves where they begin. Nothing where
/// the end is free.
std::optional<HeldEnd> held_end(const Scene& scene, const Body& string);

}  // namespace tether
