// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <string>

namespace tether {

/// Refuses an empty value of an option that needs one.
inline std::string refuse_empty(const std::string& value, const char* wanted) {
  return value.empty() ? fmt::format("{} is wanted", wanted) : std::string();
}

inline std::string refuse_no_folder(const std::string& folder) { return refuse_empty(folder, "a folder"); }
inline std::string refuse_no_file(const std::string& file) { return refuse_empty(file, "a file"); }

}  // namespace tether
