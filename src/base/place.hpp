// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace tether {

/// A place in a text the user wrote. Lines and columns count from 1 (columns in bytes); line 0 means the whole file,
/// column 0 the whole line.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
};

}  // namespace tether
