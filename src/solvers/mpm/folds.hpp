// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tether::mpm {

/// What a kernel's numbers along an axis count. A wall runs through a node and beside a cell.
enum class AxisOf { cells, nodes };

/// Places of the numbers -1 .. count along one axis, times `stride`. Number `first` stands at the low wall, `last` at
/// the high one; what stands behind a wall that mirrors shares its image's place.
inline std::vector<std::size_t> folded_axis(AxisOf what, int count, int first, int last, bool mirror_low,
                                            bool mirror_high, std::size_t stride) {
  const int beside = what == AxisOf::cells ? 1 : 0;
  std::vector<std::size_t> place;
  for (int k = -1; k <= count; ++k) {
    const int image = mirror_low && k < first   ? 2 * first - beside - k
                      : mirror_high && k > last ? 2 * last + beside - k
                                                : k;
    place.push_back(static_cast<std::size_t>(image + 1) * stride);
  }
  return place;
}

/// Sums that are all zero after clear(), which costs nothing: a sum of an earlier round counts as zero.
template <class T>
class RoundSums {
 public:
  explicit RoundSums(std::size_t count) : sums_(count) {}
  void clear() { ++round_; }
  void add(std::size_t k, const T& value) {
    Sum& sum = sums_[k];
    if (sum.round != round_) sum = {T{}, round_};
    sum.value += value;
  }
  T operator[](std::size_t k) const { return sums_[k].round == round_ ? sums_[k].value : T{}; }

 private:
  struct Sum {
    T value{};
    std::uint64_t round = 0;
  };
  std::vector<Sum> sums_;
  std::uint64_t round_ = 0;
};

}  // namespace tether::mpm
