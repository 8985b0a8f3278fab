// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/solids.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/diagnostics.hpp"

namespace tether {
namespace {

double value_of(const Expression& expression, double t, const std::string& of) {
  const double value = expression(std::array{t});
  if (std::isfinite(value)) return value;
  throw RunError(
      fmt::format("t = {:.9g}: the expression of {}, '{}', gives {}: likely cause, a division by zero or a "
                  "function outside its range",
                  t, of, expression.text(), value));
}

}  // namespace

double Amplitude::at(double t) const {
  if (expression) return value_of(*expression, t, of);
  if (time.empty()) return 1;
  const auto next = static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), t) - time.begin());
  if (next == 0) return factor.front();
  if (next == time.size()) return factor.back();
  const double part = (t - time[next - 1]) / (time[next] - time[next - 1]);
  return factor[next - 1] + part * (factor[next] - factor[next - 1]);
}

}  // namespace tether
