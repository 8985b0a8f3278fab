// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/history_layout.hpp"

#include <fmt/format.h>

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

}  // namespace tether
