// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/points/strip.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>
#include <variant>

#include "model/find_strip.hpp"

namespace tether {

void read_strip(const Deck& deck, Scene& scene, Diagnostics& diagnostics) {
  if (!deck.logical("mpm.reduce") || diagnostics.has_errors()) return;
  std::variant<Strip, NoStrip> found = find_strip(scene);
  if (Strip* strip = std::get_if<Strip>(&found)) {
    scene.strip = std::make_shared<const Strip>(std::move(*strip));
    return;
  }
  const NoStrip& no = std::get<NoStrip>(found);
  diagnostics.add(deck.remark(Severity::error, "mpm.reduce", {1, 1},
                              fmt::format("the scene is no strip that one row of points stands for: {}", no.reason),
                              no.hint + "; or leave reduce out"));
}

}  // namespace tether
