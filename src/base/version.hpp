// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace tether {

std::string program_version();  ///< "0.1.0"
std::string git_hash();         ///< of the tree this program was built from, "-dirty" behind it if it had changes

}  // namespace tether
