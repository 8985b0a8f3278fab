// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "scene/solids.hpp"

namespace tether {

double Amplitude::at(double t) const {
  if (time.empty()) return 1;
  const auto next = static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), t) - time.begin());
  if (next == 0) return factor.front();
  if (next == time.size()) return factor.back();
  const double part = (t - time[next - 1]) / (time[next] - time[next - 1]);
  return factor[next - 1] + part * (factor[next] - factor[next - 1]);
}

}  // namespace tether
