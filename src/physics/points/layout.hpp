// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "model/scene.hpp"
#include "physics/points/state.hpp"

namespace tether::mpm {

/// Whether the points of a body run by lanes, a lane for each of eight neighbouring cells, and not one after the other.
/// That pays for all but small bodies; strings, pinned points, gas by open edges and bodies in contact go one by one.
bool runs_by_lanes(const Scene& scene, std::size_t body);

/// Puts the points of such bodies into blocks of their cells, behind those of the others; in a cell they stand in the
/// order of their numbers, whatever it was before.
void lay_out(State& state, const Scene& scene);

/// An empty slot for a point of the body that has come into the cell, Blocks::no_slot where there is no room any more.
std::size_t find_slot(State& state, std::size_t body, Blocks::Cell cell);
/// Moves what a slot remembers to another one, which was empty; the first is empty then and stands in the middle of
/// `cell`.
void move_point(State& state, std::size_t from, std::size_t to, Blocks::Cell cell);
/// A slot without a point.
void make_empty(State& state, std::size_t slot, Blocks::Cell cell);

}  // namespace tether::mpm
