// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strip.hpp"

#include <algorithm>
#include <numeric>

namespace tether {

std::size_t Strip::most_abreast() const { return abreast.empty() ? 0 : *std::ranges::max_element(abreast); }

std::size_t Unfolding::unfolded(std::size_t first, std::size_t last) const {
  if (!on()) return last - first;
  const auto begin = strip_->abreast.begin();
  return std::accumulate(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last),
                         std::size_t{0});
}

}  // namespace tether
