// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "fields/fields_in_turn.hpp"
#include "results/netcdf_file.hpp"
#include "results/results.hpp"

namespace tether {

/// A dimension of a snapshot's fields, with the places of its indices where these are fixed in space.
struct Axis {
  std::string name;
  std::size_t length = 0;
  std::vector<double> places = {};  ///< none, or as many as the length: then a coordinate variable of the axis' name
  bool grows = false;               ///< the only axis, whose length a record may change: what it lacks is no number
  char direction = 0;               ///< of the places: 'X', 'Y' or 'Z'
  double cell = 0;                  ///< size of cells, of which the places are the middles; 0 where they are nodes
};

/// Numbers that no record changes, and what they are: a mesh's nodes of its elements. Axes of one name are one.
struct FixedNumbers {
  std::string name;
  std::vector<Axis> axes;  ///< slowest first
  std::vector<double> values;
  std::vector<std::pair<std::string, std::variant<std::string, int>>> attributes;
  bool whole = true;  ///< 4-byte integers, else 8-byte floating point
};

/// What a file has beside its fields.
struct FixedPart {
  std::vector<FixedNumbers> numbers;
  std::vector<std::pair<std::string, std::string>> of_each_field;  ///< attributes of every field
  std::string conventions;                                         ///< in place of those of other files; "" for theirs
};

/// A NetCDF-4 file of fields over `time` (unlimited) and the given axes, slowest first. Which fields there are, and how
/// long they are, is settled by the first snapshot.
class SnapshotFile {
 public:
  /// Creates the file and defines the fields of `first` without writing their values; writes what is fixed. Throws
  /// FileError.
  SnapshotFile(std::filesystem::path path, std::vector<Axis> axes, const FieldsInTurn& first,
               const Provenance& provenance, FixedPart fixed = {});
  /// One more record, with the system before this returns. Throws FileError, and the records before stay readable;
  /// std::invalid_argument where the fields are not those of the first snapshot.
  void append(const FieldsInTurn& snapshot) { append(snapshot, {}); }
  /// The same, and hands each field's numbers on to `also`, where there is one.
  using TakeField = std::function<void(std::size_t field, std::span<const double> numbers)>;
  void append(const FieldsInTurn& snapshot, const TakeField& also);
  void close() { file_.close(); }

 private:
  bool grows() const { return axes_.front().grows; }
  void define(const FieldsInTurn& first, const Provenance& provenance);
  int define_places(const Axis& axis, int dimension, Units units);
  int define_field(const Quantity& quantity, const std::vector<int>& dimensions, Units units);
  int dimension(const Axis& axis);
  std::vector<int> define_fixed();
  void put(std::size_t field, const NetcdfFile::Part& part, std::span<const double> numbers, std::vector<double>& room);
  /// Numbers of each field; throws where there are others than in the first snapshot.
  std::size_t checked_length(const FieldsInTurn& snapshot) const;

  std::vector<Axis> axes_;
  FixedPart fixed_;
  std::size_t values_;  ///< numbers of one field: the product of the axes' lengths, the largest so far
  NetcdfFile file_;
  std::map<std::string, int> dimensions_;  ///< of all axes by name
  int time_ = -1;
  std::vector<std::string> names_;
  std::vector<bool> whole_;
  std::vector<int> variables_;  ///< of the fields
  std::size_t records_ = 0;
};

}  // namespace tether
