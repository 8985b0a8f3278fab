// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace tether {

/// What a user may have meant by a name that is none of these: the nearest one, or else all of them.
std::string meant(const std::string& name, const std::vector<std::string>& known);

}  // namespace tether
