// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/scene.hpp"
#include "physics/points/state.hpp"

namespace tether::mpm {

/// Whether the points of a body run by lanes, a lane for each of eight neighbouring cells, and not one after the other.
/// That pays for all but small bodies; strings, pinned points, gas by open edges and bodies in contact go one by one.
bool runs_by_lanes(const Scene& scene, std::size_t body);

/// Puts the points of such bodies into blocks of their cells, behind those of the others; in a cell they stand in the
/// order of their numbers, whatever it was before.
void lay_out(State& state, const Scene& scene);

/// Points of a body on their way from slot to slot. All leave before one enters, so that what goes on together finds
/// the room that it leaves.
class Movers {
 public:
  Movers(State& state, std::size_t body);

  /// Takes a point out of its slot, which stands empty in the cell that it has left.
  void take(std::size_t slot, Blocks::Cell left, Blocks::Cell entered);
  /// Gives each a slot of the cell that it has entered; where there is no room any more, Blocks::scattered() says that
  /// all must be laid out anew.
  void settle();

 private:
  struct Mover {
    int id;
    std::uint8_t pinned;
    Blocks::Cell left, entered;
  };
  std::size_t find_slot(Blocks::Cell cell);
  void close_ranks(Blocks::Cell cell);
  void put(std::size_t mover, std::size_t slot);

  State& state_;
  std::size_t body_;
  std::vector<double*> arrays_;  // of what points have
  std::vector<Mover> movers_;
  std::vector<double> numbers_;  // of each mover, one from each array
};

}  // namespace tether::mpm
