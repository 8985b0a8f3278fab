// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/seal.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <functional>
#include <numeric>
#include <optional>
#include <string_view>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "results/netcdf_file.hpp"

namespace tether {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t digits = 64;  // of a SHA-256 in hexadecimal

/// How a 64-bit-offset file begins an attribute `checksum` of 64 characters: name, type NC_CHAR, length.
/// Source: NetCDF classic format specification.
constexpr auto head =
    "\0\0\0\x08"
    "checksum"
    "\0\0\0\x02\0\0\0\x40"sv;

/// Returns where the digits stand; npos where there are none.
std::size_t place_of_digits(const std::string& bytes) {
  const auto at = bytes.find(head);
  const bool whole = at != std::string::npos && at + head.size() + digits <= bytes.size();
  return whole ? at + head.size() : std::string::npos;
}

}  // namespace

void define_seal(NetcdfFile& file) { file.global_attribute("checksum", std::string(digits, '0')); }

void seal(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(static_cast<std::streamoff>(place_of_digits(bytes)));
  file << sha256(bytes) << std::flush;
  if (!file) throw FileError(fmt::format("{}: its checksum cannot be written", path.string()));
}

std::string broken_seal(const std::filesystem::path& path) {
  std::string bytes = read_file(path);
  const auto at = place_of_digits(bytes);
  if (at == std::string::npos) return "it is no checkpoint, or its beginning is damaged";
  const std::string told = bytes.substr(at, digits);
  bytes.replace(at, digits, digits, '0');
  return sha256(bytes) == told ? "" : "it is damaged: its checksum does not fit";
}

namespace {

Snapshot read_snapshot(const NetcdfInput& file, const Snapshot& like, std::size_t record) {
  Snapshot snapshot{file.numbers("time", {{record}, {1}}).front(), {}};
  for (const Field& field : like.fields) {
    auto count = file.shape(field.quantity.name);
    std::vector<std::size_t> start(count.size(), 0);
    start.front() = record, count.front() = 1;
    snapshot.fields.push_back({field.quantity, file.numbers(field.quantity.name, {start, count})});
  }
  return snapshot;
}

/// Without what a record has in place of points that others have: there `id` is no number.
void cut_to_points(Snapshot& snapshot) {
  for (const Field& field : snapshot.fields) {
    if (field.quantity.name != "id") continue;
    const auto points = std::count_if(field.values.begin(), field.values.end(), [](double id) { return id > 0; });
    for (Field& each : snapshot.fields) each.values.resize(static_cast<std::size_t>(points));
    return;
  }
}

void check_run(const NetcdfInput& file, const std::filesystem::path& path, const WantedSnapshots& wanted) {
  bool fits = file.global_attribute(run_attribute) == wanted.run_sha256;
  for (const Field& field : wanted.like.fields) {
    const auto shape = file.shape(field.quantity.name);
    const auto numbers = std::accumulate(shape.begin() + 1, shape.end(), std::size_t{1}, std::multiplies<>());
    fits = fits && (wanted.changing || numbers == field.values.size());
  }
  if (!fits) throw FileError(fmt::format("{}: is of another run", path.string()));
}

/// The next snapshot, or nothing and why.
std::optional<Snapshot> read_or_say_why_not(const std::function<Snapshot()>& read, std::string& why) {
  try {
    return read();
  } catch (const FileError& error) {
    why = error.what();
    return std::nullopt;
  }
}

}  // namespace

std::string replay_snapshots(const std::filesystem::path& path, const WantedSnapshots& wanted,
                             const std::function<void(const Snapshot&)>& append) {
  std::optional<NetcdfInput> file;
  for (std::size_t done = 0; done < wanted.count; ++done) {
    std::string why;
    const auto read = [&] {
      if (!file) check_run(file.emplace(path), path, wanted);
      Snapshot snapshot = read_snapshot(*file, wanted.like, done);
      if (wanted.changing) cut_to_points(snapshot);
      return snapshot;
    };
    const auto snapshot = read_or_say_why_not(read, why);
    if (!snapshot)
      return fmt::format("{} of {} earlier snapshots are lost: {}", wanted.count - done, wanted.count, why);
    append(*snapshot);
  }
  return "";
}

}  // namespace tether
