// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/scene.hpp"
#include "results/results.hpp"

namespace tether {

/// The keys of the summary.txt that a run of a scene with this exact solution writes, in order.
std::vector<std::string> summary_keys(ReferenceKind reference);

/// Keys that a run of bodies or of a flow on a mesh adds; where they are rigid, the first three.
std::vector<std::string> mesh_summary_keys();

/// Keys of a material point run with strings or membranes.
std::vector<std::string> string_summary_keys();

/// Keys of a material point run with several gases whose density is that of cells, and with gas and membranes that part
/// the grid.
std::vector<std::string> gas_summary_keys();

/// Keys of a material point run with solids or linear fluids.
std::vector<std::string> solid_points_summary_keys();

/// Keys of runs with elastic bodies of elements of order 1.
std::vector<std::string> locking_summary_keys();

/// The key of statics, and that of steady flows.
std::vector<std::string> residual_summary_keys();

/// Keys of runs of bodies that nothing but loads acts on.
std::vector<std::string> momentum_summary_keys();

/// Keys that a flow with force_on(k), speed and length adds: drag_1, lift_1 ...
std::vector<std::string> coefficient_summary_keys();

/// Keys that a run of elastic bodies on a mesh adds, also in a flow or in a box.
std::vector<std::string> body_summary_keys();

/// Keys of numbers that a run of a flow adds to these.
std::vector<std::string> flow_summary_keys();

/// Keys of numbers that a run of a fluid in a box adds; added_mass_ratio where solids and fluid are split.
std::vector<std::string> coupled_summary_keys();

/// summary.txt, or another file of lines `key = value` and remarks `# ...`; other lines are passed over. Throws
/// FileError where it cannot be read.
Summary read_summary(const std::filesystem::path& path);

}  // namespace tether
