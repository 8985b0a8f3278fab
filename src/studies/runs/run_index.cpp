// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/runs/run_index.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>
#include <set>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "base/numbers.hpp"
#include "base/text.hpp"
#include "results/text_file.hpp"

namespace tether {
namespace {

/// Parts of a line before its values: key, seconds, sizes and times of files.
constexpr std::size_t parts_before_values = 7;

std::vector<std::string> split(const std::string& line, char at) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (std::size_t to = line.find(at); to != std::string::npos; to = line.find(at, from)) {
    parts.push_back(line.substr(from, to - from));
    from = to + 1;
  }
  parts.push_back(line.substr(from));
  return parts;
}

/// A line with its sum before it, by which one that was damaged is known.
constexpr std::size_t digits_of_a_sum = 16;
std::string with_sum(const std::string& line) { return sha256(line).substr(0, digits_of_a_sum) + "\t" + line; }

/// The line without it; nothing where the sum is another's.
std::string without_sum(const std::string& line) {
  if (line.size() <= digits_of_a_sum) return "";
  std::string rest = line.substr(digits_of_a_sum + 1);
  return with_sum(rest) == line ? rest : "";
}

/// The values that a study wants of a run, each once.
std::vector<std::string> names_of(const Study& study) {
  std::set<std::string> names(study.quantities.begin(), study.quantities.end());
  if (!study.criterion.key.empty()) names.insert(study.criterion.key);
  for (const WantedValue& each : study.history_values) names.insert(each.value.name());
  names.erase(exit_code_key);
  return {names.begin(), names.end()};
}

}  // namespace

RunIndex::RunIndex(const Study& study, const std::filesystem::path& out)
    : out_(out), path_(out / "runs" / "index.txt"), names_(names_of(study)) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path_, ignored)) return;
  const auto lines = split_lines(read_file(path_));
  if (lines.empty() || lines.front() != heading()) return;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const std::string line = without_sum(lines[k]);
    if (auto entry = entry_of(line, names_.size())) entries_[line.substr(0, line.find('\t'))] = *entry;
  }
}

std::optional<FinishedRun> RunIndex::find(const Variant& variant, const std::string& key) const {
  const auto found = entries_.find(key);
  if (found == entries_.end()) return std::nullopt;
  const Entry& entry = found->second;
  const auto folder = run_folder(out_, key);
  if (stamp_of(folder / "summary.txt") != entry.summary || stamp_of(folder / "history.txt") != entry.history)
    return std::nullopt;
  FinishedRun run{variant, {key, {exit_done, entry.message}, entry.cpu_seconds, entry.wall_seconds}, true, {}};
  for (std::size_t k = 0; k < names_.size(); ++k) run.values[names_[k]] = entry.values[k];
  return run;
}

void RunIndex::add(const FinishedRun& run) {
  if (run.failed()) return;
  const RunRecord& record = run.record;
  const auto folder = run_folder(out_, record.key);
  Entry entry{.cpu_seconds = record.cpu_seconds,
              .wall_seconds = record.wall_seconds,
              .summary = stamp_of(folder / "summary.txt"),
              .history = stamp_of(folder / "history.txt"),
              .values = {},
              .message = record.ending.message};
  const auto before = entries_.find(record.key);
  const bool is_known =
      before != entries_.end() && before->second.summary == entry.summary && before->second.history == entry.history;
  if (is_known) return;
  for (const std::string& name : names_) {
    const auto value = run.values.find(name);
    if (value == run.values.end()) return;
    entry.values.push_back(value->second);
  }
  entries_[record.key] = std::move(entry);
  is_new_ = true;
}

void RunIndex::write() {
  if (!is_new_ || entries_.size() < 2) return;  // a single run is read from its own files as fast
  std::string text = heading() + "\n";
  for (const auto& [key, entry] : entries_) text += with_sum(line_of(key, entry)) + "\n";
  try {
    replace_file(path_, text);
  } catch (const FileError&) {  // the runs' own files have all that it repeats
  }
  is_new_ = false;
}

RunIndex::Stamp RunIndex::stamp_of(const std::filesystem::path& file) {
  struct stat there {};
  if (::stat(file.c_str(), &there) != 0) return {};
  return {there.st_size, 1'000'000'000LL * there.st_mtim.tv_sec + there.st_mtim.tv_nsec};
}

std::optional<RunIndex::Entry> RunIndex::entry_of(const std::string& line, std::size_t values) {
  const auto parts = split(line, '\t');
  if (parts.size() != parts_before_values + values + 1) return std::nullopt;
  const auto cpu = parse_real(parts[1]), wall = parse_real(parts[2]);
  std::vector<long long> stamps;
  for (std::size_t k = 3; k < parts_before_values; ++k) stamps.push_back(parse_integer(parts[k]).value_or(-2));
  if (!cpu || !wall) return std::nullopt;
  Entry entry{*cpu, *wall, {stamps[0], stamps[1]}, {stamps[2], stamps[3]}, {}, parts.back()};
  for (std::size_t k = 0; k < values; ++k) {
    const auto value = parse_real(parts[parts_before_values + k]);
    if (!value) return std::nullopt;
    entry.values.push_back(*value);
  }
  return entry;
}

std::string RunIndex::line_of(const std::string& key, const Entry& entry) const {
  std::string text =
      fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}", key, entry.cpu_seconds, entry.wall_seconds, entry.summary.bytes,
                  entry.summary.nanoseconds, entry.history.bytes, entry.history.nanoseconds);
  for (const double value : entry.values) text += fmt::format("\t{}", value);
  std::string message = entry.message;
  for (char& c : message) {
    if (c == '\t') c = ' ';
  }
  return text + "\t" + message;
}

/// Names what stands in a line, so that an index with other values is not taken for this one.
std::string RunIndex::heading() const {
  return fmt::format(
      "# sum\tkey\tcpu_seconds\twall_seconds\tsummary_bytes\tsummary_time\thistory_bytes\thistory_time\t{}{}message",
      fmt::join(names_, "\t"), names_.empty() ? "" : "\t");
}

}  // namespace tether
