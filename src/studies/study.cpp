// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/study.hpp"

#include <cmath>

namespace tether {

std::vector<double> Bisection::next() const {
  if (!low_holds_ && !high_holds_) return {interval_.low, interval_.high};
  if (verdict() != "not yet" || !ends_differ()) return {};
  return {0.5 * (holds_ + fails_)};
}

void Bisection::take(double value, bool holds) {
  if (value == interval_.low) low_holds_ = holds;
  if (value == interval_.high) high_holds_ = holds;
  if (holds) holds_ = std::fmax(holds_, value);  // of a value and none, the value
  if (!holds) fails_ = std::fmin(fails_, value);
}

std::string Bisection::verdict() const {
  if (!low_holds_ || !high_holds_) return "not yet";
  if (*low_holds_ && *high_holds_) return "both ends hold";
  if (!*low_holds_ && !*high_holds_) return "both ends fail";
  if (!*low_holds_) return "fails at the lower end alone";
  // Of the ends given, not of the present ones: about 0 those would never be close enough.
  const double larger = std::fmax(std::abs(interval_.low), std::abs(interval_.high));
  return fails_ - holds_ <= interval_.tolerance * larger ? "found" : "not yet";
}

std::vector<std::size_t> leading_axes(const Study& study) {
  std::vector<std::size_t> leading;
  for (std::size_t a = 0; a < study.axes.size(); ++a) {
    if (study.axes[a].leader == a) leading.push_back(a);
  }
  return leading;
}

}  // namespace tether
