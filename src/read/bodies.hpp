// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "deck/particle_file.hpp"
#include "model/scene.hpp"
#include "read/points/geometry.hpp"

namespace tether {

/// Adds region r (from 1) as a body: in each cell a sqrt(nprg) x sqrt(nprg) lattice at the middles of sub-cells, kept
/// where it lies in the region. A point's volume is that of its sub-cell, about an axis times the ring of its radius.
void add_region(const Deck& deck, int r, Scene& scene, Diagnostics& diagnostics);

/// Reports the same mistakes, but for those that need the grid.
void check_region(const Deck& deck, int r, Diagnostics& diagnostics);

/// Returns what the deck draws as region r; nothing where there are mistakes.
std::optional<RegionShape> region_shape(const Deck& deck, int r);

/// Adds the particle file as a body. A point's volume is dx dy / np2 (5.4.4), about an axis times the ring of its
/// radius.
void add_file_body(const Deck& deck, const ParticleFile& file, Scene& scene, Diagnostics& diagnostics);

/// Reports where the file's string does not hold together: once its pins are known.
void tell_file_gaps(const ParticleFile& file, const Body& body, const Scene& scene, Diagnostics& diagnostics);

/// $points: masses of heavy points, which keep their volume, the points whose paths are recorded, and those that are
/// pinned. `file_first` is the scene's number of the particle file's first row, `file_rows` the number of rows.
void apply_points_group(const Deck& deck, std::size_t file_first, std::size_t file_rows, Scene& scene,
                        Diagnostics& diagnostics);

/// Pins these points, which are a membrane's. Warns at `pinned` of the group where the scene's method measures strain
/// at points: a pin then holds little.
void pin_points(const Deck& deck, AnyVariable pinned, Subscript at, const std::vector<std::size_t>& points,
                Scene& scene, Diagnostics& diagnostics);

}  // namespace tether
