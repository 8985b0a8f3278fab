// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/liquid.hpp"

namespace tether {

bool contains(const LiquidRegion& region, const Vec<3>& x) {
  if (const Figure* figure = std::get_if<Figure>(&region.shape)) return contains(*figure, x);
  return x[1] <= (*std::get<Below>(region.shape).height)(std::array{x[0], x[2]});
}

}  // namespace tether
