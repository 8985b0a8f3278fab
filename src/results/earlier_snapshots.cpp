// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/earlier_snapshots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/errors.hpp"
#include "results/netcdf_input.hpp"

namespace tether {
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

}  // namespace

std::string replay_snapshots(const std::filesystem::path& path, const Snapshot& like, std::size_t count,
                             const std::function<void(const Snapshot&)>& append) {
  std::size_t done = 0;
  try {
    std::optional<NetcdfInput> file;
    if (count > 0) file.emplace(path);
    std::optional<Snapshot> next;
    for (; done < count; ++done) append(read_snapshot(*file, like, done));
  } catch (const FileError& error) {
    return fmt::format("{} of {} earlier snapshots are lost: {}", count - done, count, error.what());
  }
  return "";
}

}  // namespace tether
