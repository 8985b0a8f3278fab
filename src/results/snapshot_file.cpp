// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/snapshot_file.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

#include "results/netcdf_file.hpp"
#include "results/text_file.hpp"

namespace tether {
namespace {

/// What HDF5 needs beside the numbers, at most: object headers and the nodes of one chunk index a variable (3 kB each,
/// a few of which split at once), 8 kB at a time.
constexpr std::size_t room_per_variable = 16384;
constexpr std::size_t room_per_file = 65536;

std::size_t product(const std::vector<Axis>& axes) {
  return std::accumulate(axes.begin(), axes.end(), std::size_t{1},
                         [](std::size_t n, const Axis& axis) { return n * axis.length; });
}

std::size_t definition_room(const std::vector<Axis>& axes, const FieldsInTurn& first, const Provenance& provenance,
                            const std::vector<FixedNumbers>& fixed) {
  std::size_t room = provenance_room(provenance) + room_per_file;
  room += (first.quantities().size() + axes.size() + 1) * room_per_variable;
  for (const auto& axis : axes) room += axis.places.size() * sizeof(double);
  for (const auto& numbers : fixed) room += room_per_variable + numbers.values.size() * sizeof(double);
  return room;
}

}  // namespace

SnapshotFile::SnapshotFile(std::filesystem::path path, std::vector<Axis> axes, const FieldsInTurn& first,
                           const Provenance& provenance, FixedPart fixed)
    : axes_(std::move(axes)),
      fixed_(std::move(fixed)),
      values_(product(axes_)),
      file_(std::move(path), NetcdfFormat::netcdf4, definition_room(axes_, first, provenance, fixed_.numbers)) {
  define(first, provenance);
}

void SnapshotFile::define(const FieldsInTurn& first, const Provenance& provenance) {
  write_provenance(file_, provenance);
  if (!fixed_.conventions.empty()) file_.global_attribute("Conventions", fixed_.conventions);
  std::vector<int> dimensions{file_.dimension("time", NetcdfFile::unlimited)};
  time_ = define_quantity(file_, {"time", Dimension::time, "time"}, dimensions, provenance.units);
  std::vector<std::size_t> chunk{1};
  std::vector<int> places;
  for (const auto& axis : axes_) {
    dimensions.push_back(dimension(axis));
    chunk.push_back(axis.length);
    if (axis.places.empty()) continue;
    const Quantity place{axis.name, Dimension::length, "place of the nodes"};
    places.push_back(define_quantity(file_, place, {dimensions.back()}, provenance.units));
  }
  for (const Quantity& quantity : first.quantities()) {
    names_.push_back(quantity.name);
    variables_.push_back(define_quantity(file_, quantity, dimensions, provenance.units));
    for (const auto& [name, text] : fixed_.of_each_field) file_.attribute(variables_.back(), name, text);
    file_.chunk(variables_.back(), chunk);
    if (grows()) file_.fill_with_nan(variables_.back());
  }
  const std::vector<int> fixed = define_fixed();
  file_.end_definitions();
  for (std::size_t k = 0; k < fixed.size(); ++k) {
    NetcdfFile::Part whole;
    for (const auto& axis : fixed_.numbers[k].axes) whole.start.push_back(0), whole.count.push_back(axis.length);
    file_.put(fixed[k], whole, fixed_.numbers[k].values);
  }
  auto place = places.begin();
  for (const auto& axis : axes_) {
    if (!axis.places.empty()) file_.put(*place++, {{0}, {axis.length}}, axis.places);
  }
  file_.sync();
}

int SnapshotFile::dimension(const Axis& axis) {
  const auto [known, fresh] = dimensions_.try_emplace(axis.name, -1);
  if (fresh) known->second = file_.dimension(axis.name, axis.grows ? NetcdfFile::unlimited : axis.length);
  return known->second;
}

std::vector<int> SnapshotFile::define_fixed() {
  std::vector<int> variables;
  for (const auto& numbers : fixed_.numbers) {
    std::vector<int> dimensions;
    for (const auto& axis : numbers.axes) dimensions.push_back(dimension(axis));
    variables.push_back(numbers.whole ? file_.integer_variable(numbers.name, dimensions)
                                      : file_.number_variable(numbers.name, dimensions));
    for (const auto& attribute : numbers.attributes) {
      std::visit([&](const auto& value) { file_.attribute(variables.back(), attribute.first, value); },
                 attribute.second);
    }
  }
  return variables;
}

std::size_t SnapshotFile::checked_length(const FieldsInTurn& snapshot) const {
  if (snapshot.quantities().size() != names_.size()) {
    throw std::invalid_argument(
        fmt::format("a snapshot of {} fields, {} in the first", snapshot.quantities().size(), names_.size()));
  }
  const std::size_t length = grows() ? snapshot.count() : values_;
  for (std::size_t k = 0; k < names_.size(); ++k) {
    const Quantity& quantity = snapshot.quantities()[k];
    if (quantity.name != names_[k] || snapshot.count() != length) {
      throw std::invalid_argument(fmt::format("field {} with {} numbers where {} with {} was expected", quantity.name,
                                              snapshot.count(), names_[k], length));
    }
  }
  return length;
}

void SnapshotFile::append(const FieldsInTurn& snapshot) {
  values_ = std::max(values_, checked_length(snapshot));
  file_.reserve(variables_.size() * (values_ * sizeof(double) + room_per_variable) + room_per_file);
  file_.put(time_, {{records_}, {1}}, std::array{snapshot.time()});
  NetcdfFile::Part part{{records_}, {1}};
  for (const auto& axis : axes_) {
    part.start.push_back(0);
    part.count.push_back(axis.grows ? values_ : axis.length);
  }
  // With no numbers in place of points that other records have.
  std::vector<double> room(values_, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < variables_.size(); ++k) {
    const auto numbers = snapshot.numbers(k, std::span(room).first(snapshot.count()));
    if (numbers.size() == values_) {
      file_.put(variables_[k], part, numbers);
    } else {
      if (numbers.data() != room.data()) std::copy(numbers.begin(), numbers.end(), room.begin());
      file_.put(variables_[k], part, room);
    }
  }
  file_.sync();
  ++records_;
}

namespace {

std::vector<std::string> field_names(const FieldsInTurn& snapshot) {
  std::vector<std::string> names;
  for (const Quantity& quantity : snapshot.quantities()) names.push_back(quantity.name);
  return names;
}

void check_points(const FieldsInTurn& first) {
  const auto names = field_names(first);
  const auto has = [&names](const char* name) { return std::find(names.begin(), names.end(), name) != names.end(); };
  if (!has("x") || !has("y")) throw std::invalid_argument("a snapshot of points needs the fields x and y");
  if (first.count() == 0) throw std::invalid_argument("a snapshot without points");
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

void PointWriter::append(const FieldsInTurn& snapshot) {
  if (!file_) {
    check_points(snapshot);
    const std::vector<Axis> axes{{"point", snapshot.count(), {}, changing_}};
    file_.emplace(folder_ / "particles.nc", axes, snapshot, provenance_);
    series_ = {"particles.nc", field_names(snapshot), {}};
  }
  file_->append(snapshot);
  series_.times.push_back(snapshot.time());
  counts_.push_back(snapshot.count());
  replace_file(folder_ / "particles.xmf", xdmf_points(series_, counts_));
}

void PointWriter::close() {
  if (file_) file_->close();
}

GridWriter::GridWriter(std::filesystem::path folder, Provenance provenance)
    : folder_(std::move(folder)), provenance_(std::move(provenance)) {}

void GridWriter::append(const BackgroundGrid& grid, const FieldsInTurn& snapshot) {
  if (!file_) {
    const std::vector<Axis> axes{nodes("node_y", grid.ny, grid.y0, grid.dy),
                                 nodes("node_x", grid.nx, grid.x0, grid.dx)};
    file_.emplace(folder_ / "mesh.nc", axes, snapshot, provenance_);
    grid_ = grid;
    series_ = {"mesh.nc", field_names(snapshot), {}};
  }
  if (!(grid == grid_)) throw std::invalid_argument("the grid of the snapshots has changed");
  file_->append(snapshot);
  series_.times.push_back(snapshot.time());
  replace_file(folder_ / "mesh.xmf", xdmf_grid(series_, grid));
}

void GridWriter::close() {
  if (file_) file_->close();
}

}  // namespace tether
