// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "model/scene.hpp"
#include "physics/points/state.hpp"

namespace tether::mpm {

/// Returns whether the points of a body run by lanes, a lane for each of eight neighbouring cells, and not one after
/// the other. That pays for all but small bodies; strings, pinned points and gas by open edges go one by one.
bool runs_by_lanes(const Scene& scene, std::size_t body);

/// Puts the points of such bodies into blocks of their cells, after those of the others; in a cell they stand in the
/// order of their numbers, whatever it was before.
void lay_out(State& state, const Scene& scene);

/// Slots for so many blocks and those that come in between layouts: a sixteenth, and some in small bodies.
std::size_t slots_for(std::size_t blocks);

/// Places a slot without a point.
void stand_in_the_middle(State& state, std::size_t body, std::size_t slot, Blocks::Cell cell);
/// The slots of a body's block that hold no point; `cell` is that of the first lane.
void empty_block(State& state, std::size_t body, std::size_t block, Blocks::Cell cell);

}  // namespace tether::mpm
