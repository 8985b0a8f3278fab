// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/snapshot_writer.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "results/text_file.hpp"

namespace tether {
namespace {

std::vector<std::string> field_names(const Snapshot& snapshot) {
  std::vector<std::string> names;
  for (const auto& field : snapshot.fields) names.push_back(field.quantity.name);
  return names;
}

void check_points(const Snapshot& first) {
  const auto names = field_names(first);
  const auto has = [&names](const char* name) { return std::find(names.begin(), names.end(), name) != names.end(); };
  if (!has("x") || !has("y")) throw std::invalid_argument("a snapshot of points needs the fields x and y");
  if (first.fields.front().values.empty()) throw std::invalid_argument("a snapshot without points");
}

/// Nodes along one direction, from 0: first + k step.
Axis nodes(const char* name, int count, double first, double step) {
  Axis axis{name, static_cast<std::size_t>(count), {}};
  for (int k = 0; k < count; ++k) axis.places.push_back(first + k * step);
  return axis;
}

}  // namespace

PointWriter::PointWriter(std::filesystem::path folder, Provenance provenance, bool changing)
    : folder_(std::move(folder)), provenance_(std::move(provenance)), changing_(changing) {}

void PointWriter::append(const Snapshot& snapshot) {
  if (!file_) {
    check_points(snapshot);
    const std::vector<Axis> axes{{"point", snapshot.fields.front().values.size(), {}, changing_}};
    file_.emplace(folder_ / "particles.nc", axes, snapshot, provenance_);
    series_ = {"particles.nc", field_names(snapshot), {}};
  }
  file_->append(snapshot);
  series_.times.push_back(snapshot.time);
  counts_.push_back(snapshot.fields.front().values.size());
  replace_file(folder_ / "particles.xmf", xdmf_points(series_, counts_));
}

void PointWriter::close() {
  if (file_) file_->close();
}

GridWriter::GridWriter(std::filesystem::path folder, Provenance provenance)
    : folder_(std::move(folder)), provenance_(std::move(provenance)) {}

void GridWriter::append(const BackgroundGrid& grid, const Snapshot& snapshot) {
  if (!file_) {
    const std::vector<Axis> axes{nodes("node_y", grid.ny, grid.y0, grid.dy),
                                 nodes("node_x", grid.nx, grid.x0, grid.dx)};
    file_.emplace(folder_ / "mesh.nc", axes, snapshot, provenance_);
    grid_ = grid;
    series_ = {"mesh.nc", field_names(snapshot), {}};
  }
  if (!(grid == grid_)) throw std::invalid_argument("the grid of the snapshots has changed");
  file_->append(snapshot);
  series_.times.push_back(snapshot.time);
  replace_file(folder_ / "mesh.xmf", xdmf_grid(series_, grid));
}

void GridWriter::close() {
  if (file_) file_->close();
}

}  // namespace tether
