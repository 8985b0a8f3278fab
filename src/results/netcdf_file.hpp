// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "results/results.hpp"

namespace tether {

/// 64-bit-offset files can be read by others while they grow; NetCDF-4 files are HDF5, which XDMF can point into.
enum class NetcdfFormat { offset64, netcdf4 };

/// A NetCDF file being written. Every call is checked and throws FileError that names the file, what was being done and
/// the reason. Nothing is filled beforehand: each variable must be put as a whole (each record of it, if unlimited).
/// Source: NetCDF User's Guide, C interface.
class NetcdfFile {
 public:
  static constexpr std::size_t unlimited = 0;  ///< length of a dimension that grows

  /// Part of a variable: first index and number of values along each of its dimensions.
  struct Part {
    std::vector<std::size_t> start, count;
  };

  /// Creates the file, in place of one that is there. `room`, if any, is what its definitions need at most, in bytes:
  /// the disk is asked for it first, for the reason that reserve() gives.
  NetcdfFile(std::filesystem::path path, NetcdfFormat format, std::size_t room = 0);
  /// Closes a file that is still open, and keeps silent about failures: call close() to hear of them.
  ~NetcdfFile();
  NetcdfFile(const NetcdfFile&) = delete;
  NetcdfFile& operator=(const NetcdfFile&) = delete;

  /// Definitions; they return the identifier of the dimension or variable. A variable's dimensions are listed slowest
  /// first.
  int dimension(const std::string& name, std::size_t length);
  int number_variable(const std::string& name, const std::vector<int>& dimensions);   ///< of 8-byte floating point
  int integer_variable(const std::string& name, const std::vector<int>& dimensions);  ///< of 4 bytes; put as numbers
  int text_variable(const std::string& name, const std::vector<int>& dimensions);     ///< of single characters
  void attribute(int variable, const std::string& name, std::string_view text);
  void attribute(int variable, const std::string& name, int number);
  void global_attribute(const std::string& name, std::string_view text);
  /// NetCDF-4 only: one chunk of this shape is one piece of the file, written as soon as it is put.
  void chunk(int variable, const std::vector<std::size_t>& lengths);
  /// Fills what is not put of this variable with NaN, or with `no_whole_number` for integers.
  void fill(int variable, bool of_integers);
  void end_definitions();

  /// Puts as many values as the part has (else std::invalid_argument), the last dimension fastest.
  void put(int variable, const Part& part, std::span<const double> values);
  void put_text(int variable, const Part& part, std::string_view text);

  /// Claims room on the disk after the present end of the file, so that a full disk is met before any of a record is
  /// written and the file stays readable as it was. A 64-bit-offset file may else count a record that is not there; an
  /// HDF5 file is lost once a write to it failed, and the HDF5 library then crashes at the program's exit.
  void reserve(std::size_t bytes) const;
  /// Hands everything to the system: readers see it, and it survives the end of this program.
  void sync();
  void close();

  const std::filesystem::path& path() const { return path_; }

 private:
  int define(const std::string& name, int type, const std::vector<int>& dimensions);
  std::string variable_name(int variable) const;
  /// Throws FileError unless the status is "no error"; `doing` completes "cannot ...".
  void check(int status, std::string_view doing) const;

  std::filesystem::path path_;
  int id_ = -1;
  bool open_ = false;
};

/// Name of the attribute that is the same for all files of a run: SHA-256 of its deck.effective.
constexpr const char* run_attribute = "deck_effective_sha256";

/// The global attributes that every NetCDF file carries: Conventions, title, history, program, git_hash, deck,
/// deck_sha256, deck_effective_sha256. There is no time stamp in them: two runs of one deck write the same bytes.
void write_provenance(NetcdfFile& file, const Provenance& provenance);

/// Bytes that write_provenance takes at most.
std::size_t provenance_room(const Provenance& provenance);

/// What stands in place of an integer that is not there.
inline constexpr int no_whole_number = -2147483647;

/// Returns whether a quantity is written as an integer.
inline bool is_whole(const Quantity& quantity) { return quantity.dimension == Dimension::whole; }

/// A variable for the time over its dimension, as define_quantity(); the CF conventions, 4.4, call it an axis. It has
/// no date: readers keep "s" as a number.
int define_time(NetcdfFile& file, const Quantity& time, int dimension, Units units);

/// A variable for the quantity over these dimensions, with its `units` and `long_name`. Returns its identifier.
int define_quantity(NetcdfFile& file, const Quantity& quantity, const std::vector<int>& dimensions, Units units);

/// A NetCDF file being read. Every call throws FileError that names the file, what was being done and the reason.
/// Source: NetCDF User's Guide, C interface.
class NetcdfInput {
 public:
  explicit NetcdfInput(std::filesystem::path path);
  ~NetcdfInput();
  NetcdfInput(const NetcdfInput&) = delete;
  NetcdfInput& operator=(const NetcdfInput&) = delete;

  std::string global_attribute(const std::string& name) const;
  std::vector<std::string> variables() const;  ///< their names, in the file's order
  /// Lengths of a variable's dimensions, slowest first.
  std::vector<std::size_t> shape(const std::string& variable) const;
  std::vector<double> numbers(const std::string& variable) const;  ///< all of them
  std::vector<double> numbers(const std::string& variable, const NetcdfFile::Part& part) const;

 private:
  int find(const std::string& variable) const;
  /// Throws FileError unless the status is "no error"; `doing` completes "cannot ...".
  void check(int status, std::string_view doing) const;

  std::filesystem::path path_;
  int id_ = -1;
};

}  // namespace tether
