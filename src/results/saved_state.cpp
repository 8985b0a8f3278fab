// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/saved_state.hpp"

#include <fmt/format.h>

#include "base/errors.hpp"

namespace tether {

const std::vector<double>& saved_array(const SavedState& saved, const std::string& name, std::size_t length) {
  const auto found = saved.find(name);
  if (found == saved.end()) throw FileError(fmt::format("the saved state has no {}: of another version or path", name));
  if (length > 0 && found->second.size() != length) {
    throw FileError(fmt::format("the saved state has {} numbers for {}, not {}: of another scene or version",
                                found->second.size(), name, length));
  }
  return found->second;
}

}  // namespace tether
