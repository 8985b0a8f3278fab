// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "grid/boxes.hpp"
#include "results/results.hpp"
#include "studies/reproduce/files.hpp"

namespace tether::published {

using Numbers = std::vector<double>;

/// A quantity of a history made up for a test: over the records, one list a body.
struct MadeUpQuantity {
  std::string name;
  std::vector<Numbers> of_bodies;
};

/// Fields of the points by name, at one time.
struct MadeUpSnapshot {
  double time = 0;
  std::vector<std::pair<std::string, Numbers>> fields;
};

/// A run that was never run, written by what writes real ones.
struct MadeUpRun {
  Numbers time = {0};
  std::vector<std::pair<std::string, Numbers>> scene = {};  ///< quantities of the history
  std::vector<MadeUpQuantity> bodies = {};                  ///< those that each body has, all of as many bodies
  std::vector<MadeUpSnapshot> snapshots = {};
  Summary summary = {};

  RunFiles write(const std::filesystem::path& folder) const;
};

/// Writes mesh.nc: a field at all nodes, over its snapshots.
void write_nodes(const std::filesystem::path& folder, const BackgroundGrid& grid, const std::string& field,
                 const std::vector<Numbers>& snapshots);

}  // namespace tether::published
