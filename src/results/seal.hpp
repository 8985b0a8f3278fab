// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "results/netcdf_file.hpp"

namespace tether {

/// Makes room for the seal: the first attribute of a 64-bit-offset file, before any other.
void define_seal(NetcdfFile& file);

/// Puts the SHA-256 of the closed file (with the seal's 64 digits 0) into its seal. Throws FileError.
void seal(const std::filesystem::path& path);

/// "" where the file is as it was sealed; else what is wrong with it. No NetCDF call looks at the file before: a
/// damaged header may take the library anywhere. Throws FileError where it cannot be read at all.
std::string broken_seal(const std::filesystem::path& path);

}  // namespace tether
