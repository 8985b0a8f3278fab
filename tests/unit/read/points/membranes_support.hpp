// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "unit/read/scene_support.hpp"

namespace tether::test {

/// Of membrane 1.
constexpr const char* membrane_properties = "density(1)=2.,young(1)=100.,thickness(1)=.01\n";

/// $membrane from line 4 on with these items from line 5 on; `in` is line 3.
inline Built membranes(const std::string& items, const std::string& in = "",
                       const std::vector<std::string>& overrides = {}) {
  return build(on_unit_square(in + "$\n$membrane\n" + items + "\n$\n"), overrides);
}

/// A line of length .8 and the properties of line 5; more from line 7 on.
inline Built one_line(const std::string& more, const std::string& in = "",
                      const std::vector<std::string>& overrides = {}) {
  return membranes(membrane_properties + ("curve(1)='line',x(1,1)=.1,.9,y(1,1)=.5,.5\n" + more), in, overrides);
}

/// "line:column: message" of each warning.
inline Texts warnings(const Built& built) {
  Texts texts;
  for (const auto& d : built.diagnostics.warnings()) {
    texts.push_back(std::to_string(d.place.line) + ":" + std::to_string(d.place.column) + ": " + d.message);
  }
  return texts;
}

}  // namespace tether::test
