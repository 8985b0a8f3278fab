// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace tether {

std::size_t HistoryLayout::count(const Quantity& q) const {
  if (q.per == Per::body) return body_names.size();
  if (q.per == Per::point) return point_names.size();
  return 1;
}

std::vector<std::string> HistoryLayout::column_names() const {
  std::vector<std::string> names;
  for (const auto& q : quantities) {
    if (q.per == Per::scene) {
      names.push_back(q.name);
      continue;
    }
    for (std::size_t k = 1; k <= count(q); ++k) names.push_back(fmt::format("{}_{}", q.name, k));
  }
  return names;
}

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

}  // namespace tether
