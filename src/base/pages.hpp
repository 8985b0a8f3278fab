// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace tether {

/// Pages of zeros from the kernel. They take room once they are written to, and go back when they are released,
/// whatever else the process keeps.
constexpr std::size_t page_size = 4096;  // [B]

/// How the kernel is to hand them out: each by itself, or many at once where they will all be written to, which the
/// processor finds more easily.
enum class Pages { one_by_one, many };

/// The first of as many pages as the bytes need; throws std::bad_alloc.
std::byte* take_pages(std::size_t bytes, Pages how);
/// Gives back what take_pages() gave for as many bytes.
void release_pages(std::byte* first, std::size_t bytes);

/// Gives the kernel what has been freed and the process keeps else (keep_freed_memory()).
void give_back_freed_memory();

}  // namespace tether
