// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace tether {

/// Why bytes are no text that could be read: "the file is empty", "this is a NetCDF file" ...; and what would be right.
struct NoText {
  std::string message, hint;
};

/// Empty for a text, with or without odd bytes in it.
NoText no_text(std::string_view bytes);

}  // namespace tether
