// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/step_clock.hpp"

#include <algorithm>

namespace tether::fem {

std::string residuals_text(std::span<const double> residuals) {
  constexpr std::size_t shown = 6;
  std::string text;
  for (const double residual : residuals.last(std::min(residuals.size(), shown)))
    text += fmt::format(" {:.2g}", residual);
  return text;
}

}  // namespace tether::fem
