// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/results.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <stdexcept>

#include "base/diagnostics.hpp"

namespace tether {

std::vector<double> History::column(const std::string& name) const {
  const auto names = layout.column_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw std::out_of_range(fmt::format("the history has no column {}", name));
  const auto index = static_cast<std::size_t>(found - names.begin());
  std::vector<double> values;
  values.reserve(records.size());
  for (const auto& record : records) values.push_back(record.at(index));
  return values;
}

const std::vector<double>& saved_array(const SavedState& saved, const std::string& name) {
  const auto found = saved.find(name);
  if (found == saved.end()) throw FileError(fmt::format("the saved state has no {}: of another version or path", name));
  return found->second;
}

const std::vector<double>& saved_array(const SavedState& saved, const std::string& name, std::size_t length) {
  const std::vector<double>& numbers = saved_array(saved, name);
  if (numbers.size() != length)
    throw FileError(fmt::format("the saved state has {} numbers for {}, not {}: of another scene or version",
                                numbers.size(), name, length));
  return numbers;
}

}  // namespace tether
