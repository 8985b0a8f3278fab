// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/vec.hpp"

namespace tether {

// A strip is a scene of one cell across, between walls that slip, whose points stand side by side in rows: points at
// one place along the strip are alike, and lie in pairs at equal distances from the strip's middle. Its motion is along
// the strip alone, and uniform across: one row in the middle, with mass and volume of all, gives the nodes the same.
//
// Let eta from 0 to 1 be the place across, and W_0, W_1 the weights that points give to the two rows of nodes. They are
// 1 - eta and eta by bilinear functions. Splines reach rows beyond both walls, whose images are these two: N_2 belongs
// to node 0, N_-1 to node 1. Either way W_0 + W_1 = 1 and W_0(1 - eta) = W_1(eta), so that two points at eta and 1 -
// eta give one unit to each row, as two do in the middle, where W_0 = W_1 = 1/2. Mass, momentum along the strip and the
// gradients' part of the forces along it, which is V sigma W dN/dx, are sums of m W and V sigma W: the same for all
// rows and for one. Both rows of nodes then have one velocity along the strip. The walls take momentum and force across
// it; all that depends on the velocity's gradient across, shear, spin and the columns of APIC's field, is zero.
// Densities by cells (4.5), (4.6) add up whole masses, since the ring beyond a wall that mirrors belongs to the cell
// before it.

/// Which points of a scene run as one: the row's points are numbered in the order of the first that each stands for.
struct Strip {
  int across = 1;                      ///< the axis across: 0 is x, 1 is y
  double middle = 0;                   ///< where the row lies across [length]
  std::vector<std::uint32_t> row;      ///< of each point of the scene: the number of the row's point it moves with
  std::vector<std::uint32_t> first;    ///< of each point of the row: the first of the scene's that move with it
  std::vector<std::uint32_t> abreast;  ///< of each point of the row: how many of the scene's move with it
  std::vector<double> place;           ///< of each point of the scene: where it lies across [length]

  std::size_t points() const { return row.size(); }
  /// The most points that stand side by side.
  std::size_t most_abreast() const;
};

/// What becomes of a scene's points once a row has run: point `number` of the scene is made from a point of the row.
/// Without a strip every point is its own.
class Unfolding {
 public:
  explicit Unfolding(const Strip* strip = nullptr) : strip_(strip) {}

  bool on() const { return strip_ != nullptr; }
  /// The number of the point that runs for it.
  std::size_t runs_as(std::size_t number) const { return on() ? strip_->row[number] : number; }
  /// The number in the scene of point `number` of those that run, the first where there are several.
  std::size_t first_of(std::size_t number) const { return on() ? strip_->first[number] : number; }
  /// Its part of the mass and the volume of the point that runs for it.
  double share(std::size_t number) const { return on() ? 1.0 / strip_->abreast[strip_->row[number]] : 1; }
  /// How many points of the scene are made from points first .. last - 1 of those that run.
  std::size_t unfolded(std::size_t first, std::size_t last) const;
  /// Its place, where the point that runs for it is at `here`.
  Vec<2> place(std::size_t number, Vec<2> here) const {
    if (on()) here[static_cast<std::size_t>(strip_->across)] = strip_->place[number];
    return here;
  }

 private:
  const Strip* strip_ = nullptr;
};

}  // namespace tether
