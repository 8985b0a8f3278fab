// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tether {

/// The methods that can run a scene: material points, finite elements, fluid and solids on a regular grid.
enum class Path { mpm, fem, coupled };

/// The word for it on the command line and in summary.txt.
constexpr const char* path_name(Path path) { return path == Path::mpm ? "mpm" : path == Path::fem ? "fem" : "coupled"; }

}  // namespace tether
