// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "base/errors.hpp"
#include "results/checkpoint.hpp"

namespace tether {
namespace {

constexpr std::size_t kept = 2;
const std::string prefix = "checkpoint-", suffix = ".nc";

/// N of checkpoint-N.nc; 0 for any other name.
unsigned long long number_of(const std::string& name) {
  if (!name.starts_with(prefix) || !name.ends_with(suffix)) return 0;
  const std::string digits = name.substr(prefix.size(), name.size() - prefix.size() - suffix.size());
  const bool number =
      !digits.empty() && digits.size() < 19 && digits.find_first_not_of("0123456789") == std::string::npos;
  return number ? std::stoull(digits) : 0;
}

unsigned long long number_of(const std::filesystem::path& path) { return number_of(path.filename().string()); }

void remove_older(const std::vector<std::filesystem::path>& newest_first) {
  for (std::size_t k = kept; k < newest_first.size(); ++k) remove_checkpoint(newest_first[k]);
}

}  // namespace

void remove_checkpoint(const std::filesystem::path& path) {
  std::error_code reason;
  std::filesystem::remove(path, reason);
  if (reason) throw FileError(fmt::format("{}: cannot be removed: {}", path.string(), reason.message()));
}

std::vector<std::filesystem::path> checkpoints_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> found;
  std::error_code reason;  // of a folder that is not there: nothing is in it
  for (const auto& entry : std::filesystem::directory_iterator(folder, reason)) {
    if (number_of(entry.path()) > 0) found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return number_of(a) > number_of(b); });
  return found;
}

std::filesystem::path add_checkpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint) {
  const auto before = checkpoints_in(folder);
  const auto number = before.empty() ? 1 : number_of(before.front()) + 1;
  auto path = folder / fmt::format("{}{}{}", prefix, number, suffix);
  write_checkpoint(path, checkpoint);
  remove_older(checkpoints_in(folder));
  return path;
}

}  // namespace tether
