// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#include "base/pages.hpp"

namespace tether {

/// Memory for arrays that lanes run over: it begins at a line of the cache, so that eight lanes lie in one. Long arrays
/// have pages of their own, and begin at unlike places of their first page: the numbers of one point in all of them
/// would else compete for one place of the cache.
template <class Number>
class LineAllocator {
 public:
  using value_type = Number;

  LineAllocator() = default;
  template <class Other>
  LineAllocator(const LineAllocator<Other>&) {}

  Number* allocate(std::size_t n) {
    const std::size_t bytes = n * sizeof(Number);
    if (!is_long(n)) return static_cast<Number*>(::operator new(bytes, std::align_val_t(line)));
    std::byte* begin = take_pages(bytes + page_size, Pages::many);
    return reinterpret_cast<Number*>(begin + line * lines_on(begin));
  }
  void deallocate(Number* array, std::size_t n) {
    if (!is_long(n)) return ::operator delete(array, std::align_val_t(line));
    const std::size_t ahead = reinterpret_cast<std::uintptr_t>(array) % page_size;
    release_pages(reinterpret_cast<std::byte*>(array) - ahead, n * sizeof(Number) + page_size);
  }
  friend bool operator==(LineAllocator, LineAllocator) { return true; }

 private:
  static constexpr std::size_t line = 64;
  static bool is_long(std::size_t n) { return n * sizeof(Number) >= 8 * page_size; }
  /// From the page's number, whose neighbours get unlike ones.
  static std::size_t lines_on(const void* begin) {
    constexpr std::uint64_t spread = 0x9E3779B97F4A7C15;  // 2^64 over the golden ratio
    return (static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(begin) / page_size) * spread) >> 58;
  }
};

/// An array of numbers of points.
template <class Number>
using LineArray = std::vector<Number, LineAllocator<Number>>;

/// Memory of zeros, of which an array takes as much as has been written to: pages that nobody writes to take none.
/// Numbers that are not given when the array is made are 0; it does not grow later.
template <class Number>
class ZeroAllocator {
 public:
  using value_type = Number;

  ZeroAllocator() = default;
  template <class Other>
  ZeroAllocator(const ZeroAllocator<Other>&) {}

  Number* allocate(std::size_t n) {
    if (!is_long(n)) return new Number[n]();
    return reinterpret_cast<Number*>(take_pages(n * sizeof(Number), Pages::one_by_one));
  }
  void deallocate(Number* array, std::size_t n) {
    if (!is_long(n)) return delete[] array;
    release_pages(reinterpret_cast<std::byte*>(array), n * sizeof(Number));
  }
  /// A number that is not given: it is 0 already.
  void construct(Number*) {}
  template <class... Of>
  void construct(Number* at, Of&&... of) {
    std::construct_at(at, std::forward<Of>(of)...);
  }
  friend bool operator==(ZeroAllocator, ZeroAllocator) { return true; }

 private:
  static bool is_long(std::size_t n) { return n * sizeof(Number) >= 8 * page_size; }
};

}  // namespace tether
