// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/process.hpp"
#include "base/version_values.hpp"

namespace tether {

std::string program_version() { return TETHER_VERSION; }
std::string git_hash() { return TETHER_GIT_HASH; }

}  // namespace tether
