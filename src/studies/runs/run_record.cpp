// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/runs/run_record.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "base/numbers.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "plan/load.hpp"
#include "read/mesh/mesh_of_file.hpp"
#include "read/points/points_group.hpp"
#include "results/summary_keys.hpp"
#include "results/text_file.hpp"

namespace tether {
namespace {

constexpr std::size_t key_digits_in_a_name = 16, key_digits_above = 2;

/// Returns the SHA-256 of a file of the run's, so that one that a power cut emptied is not taken for the run's; ""
/// where there is none.
std::string file_sha256(const std::filesystem::path& path) {
  return std::filesystem::exists(path) ? sha256(read_file(path)) : "";
}

/// The files that a study takes its numbers from, and what the record calls their sums.
struct Summed {
  const char *name, *file;
};
constexpr std::array summed{Summed{"summary_sha256", "summary.txt"}, Summed{"history_sha256", "history.txt"}};

/// Returns whether they are as the run left them; of one that ended well the summary is there.
bool is_whole(const std::filesystem::path& folder, std::map<std::string, std::string>& lines) {
  const auto same = [&](const Summed& sum) { return lines[sum.name] == file_sha256(folder / sum.file); };
  return !lines["summary_sha256"].empty() && std::all_of(summed.begin(), summed.end(), same);
}

}  // namespace

std::string run_key(const Deck& deck) {
  Diagnostics of_the_run;  // which meets them itself, and fails with them
  const Deck whole = load_mesh(deck, of_the_run);
  const auto particles = load_particles(whole, std::nullopt, of_the_run);
  return sha256(fmt::format("{} {}\n{}", program_version(), git_hash(), effective_text(whole, particles)));
}

std::filesystem::path run_folder(const std::filesystem::path& out, const std::string& key) {
  return out / "runs" / key.substr(0, key_digits_above) / key.substr(0, key_digits_in_a_name);
}

std::optional<RunRecord> read_record(const std::filesystem::path& folder, const std::string& key) {
  std::map<std::string, std::string> lines;
  if (!std::filesystem::exists(folder / "run.txt")) return std::nullopt;
  for (auto& [name, value] : read_summary(folder / "run.txt")) lines[name] = std::move(value);
  const auto code = parse_integer(lines["exit_code"]);
  const auto cpu = parse_real(lines["cpu_seconds"]), wall = parse_real(lines["wall_seconds"]);
  if (lines["key"] != key || !code || !cpu || !wall) return std::nullopt;
  if (*code == exit_done && !is_whole(folder, lines)) return std::nullopt;
  return RunRecord{key, {static_cast<int>(*code), lines["message"], find_word<Failure>(lines["failure"])}, *cpu, *wall};
}

void write_record(const std::filesystem::path& folder, const RunRecord& record) {
  std::error_code reason;
  std::filesystem::create_directories(folder, reason);
  if (reason) throw FileError(fmt::format("{}: cannot be created: {}", folder.string(), reason.message()));
  std::string text = fmt::format("key = {}\nexit_code = {}\ncpu_seconds = {}\nwall_seconds = {}\n", record.key,
                                 record.ending.exit_code, record.cpu_seconds, record.wall_seconds);
  for (const auto& [name, file] : summed) text += fmt::format("{} = {}\n", name, file_sha256(folder / file));
  if (record.ending.failure) text += fmt::format("failure = {}\n", word_of(*record.ending.failure));
  replace_file(folder / "run.txt", text + fmt::format("message = {}\n", record.ending.message));
}

std::string one_line(const std::string& message) {
  std::vector<std::string> lines;
  for (const auto& line : split_lines(message)) {
    const auto words = trim(line);
    if (!words.empty() && words != "^") lines.emplace_back(words);
  }
  return fmt::format("{}", fmt::join(lines, " "));
}

}  // namespace tether
