// SPDX-License-Identifier: GPL-3.0-or-later
#include "unit/studies/reproduce/made_up.hpp"

#include "results/result_folder.hpp"

namespace tether::published {
namespace {

Quantity number(const std::string& name, Per per = Per::scene) { return {name, Dimension::number, name, per}; }

HistoryLayout layout_of(const MadeUpRun& run) {
  HistoryLayout layout;
  layout.quantities.push_back(number("time"));
  for (const auto& [name, values] : run.scene) layout.quantities.push_back(number(name));
  for (const auto& [name, values] : run.bodies) layout.quantities.push_back(number(name, Per::body));
  if (!run.bodies.empty()) layout.body_names.assign(run.bodies.front().of_bodies.size(), "body");
  return layout;
}

Record record_of(const MadeUpRun& run, std::size_t k) {
  Record record{run.time[k]};
  for (const auto& [name, values] : run.scene) record.push_back(values[k]);
  for (const auto& [name, of_bodies] : run.bodies) {
    for (const Numbers& values : of_bodies) record.push_back(values[k]);
  }
  return record;
}

Snapshot snapshot_of(double time, const std::vector<std::pair<std::string, Numbers>>& fields) {
  Snapshot snapshot{time, {}};
  for (const auto& [name, values] : fields) snapshot.fields.push_back({number(name), values});
  return snapshot;
}

}  // namespace

RunFiles MadeUpRun::write(const std::filesystem::path& folder) const {
  ResultFolder results(folder, layout_of(*this), {});
  for (std::size_t k = 0; k < time.size(); ++k) results.append(record_of(*this, k));
  for (const auto& snapshot : snapshots) results.points(snapshot_of(snapshot.time, snapshot.fields));
  results.finish(summary);
  return RunFiles(folder);
}

void write_nodes(const std::filesystem::path& folder, const BackgroundGrid& grid, const std::string& field,
                 const std::vector<Numbers>& snapshots) {
  ResultFolder results(folder, layout_of({}), {});
  for (std::size_t k = 0; k < snapshots.size(); ++k) {
    results.grid(grid, snapshot_of(static_cast<double>(k), {{field, snapshots[k]}}));
  }
  results.finish({});
}

}  // namespace tether::published
