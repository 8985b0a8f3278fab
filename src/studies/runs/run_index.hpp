// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "studies/combinations.hpp"

namespace tether {

/// What a study wants of its finished runs, all in one file, runs/index.txt: a line a run instead of some files, of
/// which a file system may take long to open ten thousand. Each line holds as long as the run's files have the sizes
/// and the times that they had; what is not in the index is read from these files.
class RunIndex {
 public:
  /// Reads the index below the study's folder. One that is not there, is damaged, or lacks a value that this study
  /// wants, is empty.
  RunIndex(const Study& study, const std::filesystem::path& out);

  /// A run of this key that ended well, if its files are what they were.
  std::optional<FinishedRun> find(const Variant& variant, const std::string& key) const;
  /// Takes a run that ended well, and that has all that the study wants.
  void add(const FinishedRun& run);
  /// Writes it in one go, where it has something new. Nothing is lost where that fails: it repeats what the runs have.
  void write();

 private:
  /// A file as it was: another size or time means another content. A file that is not there has the size -1.
  struct Stamp {
    long long bytes = -1, nanoseconds = 0;
    bool operator==(const Stamp&) const = default;
  };
  struct Entry {
    double cpu_seconds = 0, wall_seconds = 0;
    Stamp summary, history;
    std::vector<double> values;  // by the order of names_
    std::string message;
  };
  static Stamp stamp_of(const std::filesystem::path& file);
  static std::optional<Entry> entry_of(const std::string& line, std::size_t values);
  std::string line_of(const std::string& key, const Entry& entry) const;
  std::string heading() const;

  std::filesystem::path out_, path_;
  std::vector<std::string> names_;  // of values: keys of summary.txt, and of histories
  std::map<std::string, Entry> entries_;
  bool is_new_ = false;
};

}  // namespace tether
