// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "results/netcdf_file.hpp"
#include "results/results.hpp"

namespace tether {

/// Name of the attribute that is the same for all files of a run: SHA-256 of its deck.effective.
constexpr const char* run_attribute = "deck_effective_sha256";

/// The global attributes that every NetCDF file carries: Conventions, title, history, program, git_hash, deck,
/// deck_sha256, deck_effective_sha256. There is no time stamp in them: two runs of one deck write the same bytes.
void write_provenance(NetcdfFile& file, const Provenance& provenance);

/// Bytes that write_provenance takes at most.
std::size_t provenance_room(const Provenance& provenance);

/// A variable for the quantity over these dimensions, with its `units` and `long_name`. Returns its identifier.
int define_quantity(NetcdfFile& file, const Quantity& quantity, const std::vector<int>& dimensions, Units units);

}  // namespace tether
