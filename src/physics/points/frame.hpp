// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "grid/boxes.hpp"
#include "laws/walls.hpp"
#include "model/method.hpp"
#include "model/strip.hpp"

namespace tether::mpm {

/// A node beyond a wall and its image before it. What points give to the ghost belongs to the image; what they read
/// there is the image's. Scalars are even; of a vector a slip wall makes the normal component odd and the tangential
/// one even, a fixed wall both odd.
struct Ghost {
  int node = 0, image = 0;
  Pair sign{};
};

/// The signs of a ghost, where one stands for each node.
struct Signs {
  std::int8_t x = 1, y = 1;

  friend Pair operator*(Signs signs, Pair v) { return pair(signs.x * v[0], signs.y * v[1]); }
};

/// The nodes that a run computes with: the deck's grid, and around it what the kernel reaches to. Behind a wall that is
/// a row of ghosts; beyond an open wall there is room, padding of six cells into which points may move; beyond an edge
/// through which gas passes, by any kernel, there are the cells of its strip, and two more.
struct Frame {
  BackgroundGrid shape;      // with what is around it
  BackgroundGrid deck;       // the deck's grid
  int left = 0, bottom = 0;  // nodes before the deck's first one
  int first_row, last_row;   // of nodes, of what points give something to
  double x0, x1, y0, y1;     // where points may be [length]
  std::vector<Ghost> ghosts;
  std::vector<std::uint8_t> held;     // Held bits of the walls
  std::vector<std::size_t> at_walls;  // the nodes of which they hold something
  std::vector<std::uint32_t> image;   // of each node: a ghost's image, else itself
  std::vector<Signs> sign;            // of each node: a ghost's, else 1
  std::vector<double> per_volume;     // 1 / int N_i dV of the image: a wall's node has half, a corner's a quarter

  Frame(const BackgroundGrid& deck, const Walls& walls, Geometry geometry, Kernel kernel, const Edges& edges = {},
        const Strip* strip = nullptr);

  /// False for NaN.
  bool contains(double x, double y) const { return x >= x0 && x <= x1 && y >= y0 && y <= y1; }
  /// A place as node n sees it: from a ghost it is the place's image, which the ghost's image sees.
  Pair before_walls(std::size_t n, Pair place) const;
  /// Number in the frame of node n of the deck's grid.
  std::size_t of_deck(std::size_t n) const {
    const auto nx = static_cast<std::size_t>(deck.nx);
    return (n / nx + static_cast<std::size_t>(bottom)) * static_cast<std::size_t>(shape.nx) + n % nx +
           static_cast<std::size_t>(left);
  }

 private:
  void leave_out_ghosts_across();
};

}  // namespace tether::mpm
