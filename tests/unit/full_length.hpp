// SPDX-License-Identifier: GPL-3.0-or-later
// What `./quickstart test --full` does beyond the default run.
#pragma once

#include <cstdlib>
#include <string_view>

namespace tether::test {

/// Returns whether tests take their full length: TETHER_FULL=1 in the environment asks for it. Without it a ladder of
/// grids or steps has two levels, and what would take a minute by itself is shorter, or coarser.
inline bool at_full_length() {
  const char* asked = std::getenv("TETHER_FULL");  // NOLINT(concurrency-mt-unsafe): no thread changes it
  return asked != nullptr && std::string_view(asked) == "1";
}

}  // namespace tether::test
