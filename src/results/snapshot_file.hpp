// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "fields/fields_in_turn.hpp"
#include "grid/boxes.hpp"
#include "results/netcdf_file.hpp"
#include "results/results.hpp"
#include "results/xdmf.hpp"

namespace tether {

/// A dimension of a snapshot's fields, with the places of its indices where these are fixed in space.
struct Axis {
  std::string name;
  std::size_t length = 0;
  std::vector<double> places;  ///< none, or as many as the length: then a coordinate variable of the axis' name
  bool grows = false;          ///< the only axis, whose length a record may change: what it lacks is no number
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
  void append(const FieldsInTurn& snapshot);
  void close() { file_.close(); }

 private:
  bool grows() const { return axes_.front().grows; }
  void define(const FieldsInTurn& first, const Provenance& provenance);
  int dimension(const Axis& axis);
  std::vector<int> define_fixed();
  /// Numbers of each field; throws where there are others than in the first snapshot.
  std::size_t checked_length(const FieldsInTurn& snapshot) const;

  std::vector<Axis> axes_;
  FixedPart fixed_;
  std::size_t values_;  ///< numbers of one field: the product of the axes' lengths, the largest so far
  NetcdfFile file_;
  std::map<std::string, int> dimensions_;  ///< of all axes by name
  int time_ = -1;
  std::vector<std::string> names_;
  std::vector<int> variables_;  ///< of the fields
  std::size_t records_ = 0;
};

/// Writes particles.nc, fields over (time, point), and particles.xmf, by which ParaView opens it. Nothing is created
/// before the first snapshot; each one is with the system, and the .xmf whole, before append() returns.
/// While the run goes on its NetCDF-4 files are locked by HDF5; who wants to read them then sets
/// HDF5_USE_FILE_LOCKING=FALSE.
class PointWriter {
 public:
  /// `changing`: how many points there are.
  PointWriter(std::filesystem::path folder, Provenance provenance, bool changing = false);
  /// The snapshot has the fields `x` and `y`, and the same fields every time, and, unless their number changes, the
  /// same points; else a record with fewer than another has no numbers at its end. Throws FileError.
  void append(const FieldsInTurn& snapshot);
  void close();

 private:
  std::filesystem::path folder_;
  Provenance provenance_;
  bool changing_;
  std::vector<std::size_t> counts_;  // of points in each record
  XdmfSeries series_;
  std::optional<SnapshotFile> file_;
};

/// Writes mesh.nc, fields over (time, node_y, node_x) with the coordinates of the nodes, and mesh.xmf. As PointWriter.
class GridWriter {
 public:
  GridWriter(std::filesystem::path folder, Provenance provenance);
  /// The grid is the same every time (else std::invalid_argument). Throws FileError.
  void append(const BackgroundGrid& grid, const FieldsInTurn& snapshot);
  void close();

 private:
  std::filesystem::path folder_;
  Provenance provenance_;
  BackgroundGrid grid_;
  XdmfSeries series_;
  std::optional<SnapshotFile> file_;
};

}  // namespace tether
