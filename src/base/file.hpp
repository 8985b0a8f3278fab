// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace tether {

/// The whole file as bytes. Throws FileError with the system's reason.
std::string read_file(const std::filesystem::path& path);

/// Writes the whole text and checks every step, the close included. Throws FileError.
void write_file(const std::filesystem::path& path, std::string_view text);

}  // namespace tether
