// SPDX-License-Identifier: GPL-3.0-or-later
// The machine's limits, measured: bytes a second between one core and the memory, and between it and its second cache,
// read and written together; multiplications a second of doubles by full vectors. Prints a name and a number a line.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "plain.hpp"

namespace {

constexpr int rounds = 9;

/// Shortest of some rounds [s].
template <class Work>
double shortest(const Work& work) {
  double best = 1e300;
  for (int round = 0; round < rounds; ++round) {
    const double begin = plain::cpu();
    work();
    best = std::min(best, plain::cpu() - begin);
  }
  return best;
}

/// Bytes a second of b = 1.5 a. A factor, since a bare copy may pass the caches by.
double copy_speed(std::size_t bytes_of_both, double bytes_in_all) {
  const std::size_t count = bytes_of_both / (2 * sizeof(double));
  std::vector<double> from(count, 1.0), to(count, 0.0);
  const int times = std::max(1, static_cast<int>(bytes_in_all / static_cast<double>(bytes_of_both)));
  const double seconds = shortest([&] {
    for (int k = 0; k < times; ++k) {
      const double* __restrict a = from.data();
      double* __restrict b = to.data();
      for (std::size_t n = 0; n < count; ++n) b[n] = 1.5 * a[n];
      asm volatile("" : : "r"(b) : "memory");
    }
  });
  return 2.0 * sizeof(double) * static_cast<double>(count) * times / seconds;
}

using Vector [[gnu::vector_size(64)]] = double;

/// Of so many vectors side by side that none waits for its own result.
double multiply_speed() {
  constexpr int side_by_side = 12, times = 2'000'000;
  Vector v[side_by_side];
  double all[8] = {1 + 1e-9, 1 + 2e-9, 1 + 3e-9, 1 + 4e-9, 1 + 5e-9, 1 + 6e-9, 1 + 7e-9, 1 + 8e-9};
  Vector factor;
  std::copy(all, all + 8, reinterpret_cast<double*>(&factor));
  for (Vector& one : v) one = factor;
  const double seconds = shortest([&] {
    for (int k = 0; k < times; ++k)
#pragma GCC unroll 12
      for (int i = 0; i < side_by_side; ++i) v[i] *= factor;
  });
  volatile double used = 0;
  for (const Vector& one : v) used = used + one[0];
  return 8.0 * side_by_side * times / seconds;
}

}  // namespace

int main() {
  const long cache = std::max(sysconf(_SC_LEVEL2_CACHE_SIZE), 256L * 1024);
  std::printf("memory %.4g bytes a second\n", copy_speed(std::size_t{512} << 20, 1e9));
  std::printf("cache %.4g bytes a second\n", copy_speed(static_cast<std::size_t>(cache / 2), 4e9));
  std::printf("multiplications %.4g a second\n", multiply_speed());
}
