// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/liquid.hpp"

namespace tether {

bool contains(const LiquidRegion& region, const Vec<3>& x) {
  if (const Figure* figure = std::get_if<Figure>(&region.shape)) return contains(*figure, x);
  if (const Where* where = std::get_if<Where>(&region.shape)) return (*where->holds)(x) != 0;
  return x[1] <= (*std::get<Below>(region.shape).height)(std::array{x[0], x[2]});
}

}  // namespace tether
