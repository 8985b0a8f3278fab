// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "results/netcdf_file.hpp"

namespace tether {

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
