// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "base/words.hpp"

namespace tether {

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

}  // namespace tether
