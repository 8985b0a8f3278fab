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
  time_ = define_time(file_, {"time", Dimension::time, "time"}, dimensions.front(), provenance.units);
  std::vector<std::size_t> chunk{1};
  std::vector<int> places;
  for (const auto& axis : axes_) {
    dimensions.push_back(dimension(axis));
    chunk.push_back(axis.length);
    places.push_back(axis.places.empty() ? -1 : define_places(axis, dimensions.back(), provenance.units));
  }
  for (const Quantity& quantity : first.quantities()) {
    names_.push_back(quantity.name);
    whole_.push_back(is_whole(quantity));
    variables_.push_back(define_field(quantity, dimensions, provenance.units));
    file_.chunk(variables_.back(), chunk);
  }
  const std::vector<int> fixed = define_fixed();
  file_.end_definitions();
  for (std::size_t k = 0; k < fixed.size(); ++k) {
    NetcdfFile::Part whole;
    for (const auto& axis : fixed_.numbers[k].axes) whole.start.push_back(0), whole.count.push_back(axis.length);
    file_.put(fixed[k], whole, fixed_.numbers[k].values);
  }
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    if (places[k] >= 0) file_.put(places[k], {{0}, {axes_[k].length}}, axes_[k].places);
  }
  file_.sync();
}

/// The axis' coordinate variable; the cells' bounds become one of the fixed numbers. Source: CF conventions, 4 and 7.1.
int SnapshotFile::define_places(const Axis& axis, int dimension, Units units) {
  const bool cells = axis.cell > 0;
  const Quantity place{axis.name, Dimension::length, cells ? "middles of the cells" : "place of the nodes"};
  const int variable = define_quantity(file_, place, {dimension}, units);
  file_.attribute(variable, "axis", std::string(1, axis.direction));
  if (!cells) return variable;
  file_.attribute(variable, "bounds", axis.name + "_bounds");
  std::vector<double> bounds;
  for (const double middle : axis.places)
    bounds.push_back(middle - axis.cell / 2), bounds.push_back(middle + axis.cell / 2);
  fixed_.numbers.push_back({axis.name + "_bounds", {axis, {"side", 2}}, std::move(bounds), {}, false});
  return variable;
}

int SnapshotFile::define_field(const Quantity& quantity, const std::vector<int>& dimensions, Units units) {
  const int variable = define_quantity(file_, quantity, dimensions, units);
  for (const auto& [name, text] : fixed_.of_each_field) file_.attribute(variable, name, text);
  if (grows()) file_.fill(variable, is_whole(quantity));
  return variable;
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

void SnapshotFile::append(const FieldsInTurn& snapshot, const TakeField& also) {
  values_ = std::max(values_, checked_length(snapshot));
  file_.reserve(variables_.size() * (values_ * sizeof(double) + room_per_variable) + room_per_file);
  file_.put(time_, {{records_}, {1}}, std::array{snapshot.time()});
  NetcdfFile::Part part{{records_}, {1}};
  for (const auto& axis : axes_) {
    part.start.push_back(0);
    part.count.push_back(axis.grows ? values_ : axis.length);
  }
  std::vector<double> room(values_, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < variables_.size(); ++k) {
    const auto numbers = snapshot.numbers(k, std::span(room).first(snapshot.count()));
    if (also) also(k, numbers);
    put(k, part, numbers, room);
  }
  file_.sync();
  ++records_;
}

/// Puts no numbers in place of points that other records have; `room` may hold the numbers already.
void SnapshotFile::put(std::size_t field, const NetcdfFile::Part& part, std::span<const double> numbers,
                       std::vector<double>& room) {
  if (numbers.size() == values_) return file_.put(variables_[field], part, numbers);
  if (numbers.data() != room.data()) std::copy(numbers.begin(), numbers.end(), room.begin());
  const double none = whole_[field] ? no_whole_number : std::numeric_limits<double>::quiet_NaN();
  std::fill(room.begin() + static_cast<std::ptrdiff_t>(numbers.size()), room.end(), none);
  file_.put(variables_[field], part, room);
}

}  // namespace tether
