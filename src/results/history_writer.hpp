// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "results/netcdf_file.hpp"
#include "results/results.hpp"
#include "results/text_file.hpp"

namespace tether {

/// Writes the history twice: history.nc (CF, 64-bit offset, variables over `time`, `time, body` and `time, point`) for
/// programs, history.txt (one line a record under a header that starts with `#`, digits that read back to the same
/// numbers) for the eye. Each record is with the system before append() returns; both files can be read meanwhile.
class HistoryWriter {
 public:
  /// The files in this folder are replaced. The layout's first quantity must be `time`. Throws FileError.
  HistoryWriter(const std::filesystem::path& folder, HistoryLayout layout, const Provenance& provenance);
  /// Throws FileError; the records before stay readable.
  void append(const Record& record);
  /// Throws FileError. No append() after it.
  void close();

 private:
  void define(const Provenance& provenance);
  void write_names(int variable, const std::vector<std::string>& names);
  void append_numbers(const Record& record);
  void append_line(const Record& record);

  HistoryLayout layout_;
  std::size_t columns_;
  NetcdfFile numbers_;
  TextFile lines_;
  std::vector<int> variables_;  ///< of the layout's quantities; -1 where there is none of its bodies or points
  std::size_t records_ = 0;
};

}  // namespace tether
