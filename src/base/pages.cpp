// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/pages.hpp"

#include <malloc.h>
#include <sys/mman.h>
#include <cstdint>
#include <new>

namespace tether {
namespace {

/// What the kernel hands out at once where it can [B].
constexpr std::size_t many_pages = std::size_t{2} << 20;

std::size_t whole_pages(std::size_t bytes) { return (bytes + page_size - 1) / page_size * page_size; }

std::byte* mapping(std::size_t bytes) {
  void* begin = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (begin == MAP_FAILED) throw std::bad_alloc();
  return static_cast<std::byte*>(begin);
}

}  // namespace

std::byte* take_pages(std::size_t bytes, Pages how) {
  const std::size_t size = whole_pages(bytes);
  if (how == Pages::one_by_one || size < 2 * many_pages) return mapping(size);
  std::byte* begin = mapping(size + many_pages);
  const std::size_t ahead = (many_pages - reinterpret_cast<std::uintptr_t>(begin) % many_pages) % many_pages;
  if (ahead > 0) munmap(begin, ahead);
  if (ahead < many_pages) munmap(begin + ahead + size, many_pages - ahead);
#ifdef MADV_HUGEPAGE
  madvise(begin + ahead, size, MADV_HUGEPAGE);  // a wish: without it, pages come one by one
#endif
  return begin + ahead;
}

void give_back_freed_memory() { malloc_trim(0); }

void release_pages(std::byte* first, std::size_t bytes) { munmap(first, whole_pages(bytes)); }

}  // namespace tether
