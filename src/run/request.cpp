// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/request.hpp"

#include "base/text.hpp"

namespace tether {

RunRequest request_of(const Loaded& loaded, const std::filesystem::path& folder, const std::string& command) {
  const std::string& text = loaded.deck.text();
  const Scene& scene = loaded.plan.scene;
  std::vector<std::string> messages = loaded.warnings;
  messages.insert(messages.end(), loaded.remarks.begin(), loaded.remarks.end());
  return {.folder = folder,
          .provenance = {scene.title, command, text, sha256(text), scene.units, sha256(loaded.effective)},
          .deck_effective = loaded.effective,
          .messages = std::move(messages),
          .progress = {},
          .warn = {},
          .interrupted = {},
          .restart = {},
          .mesh_text = loaded.deck.mesh_text(),
          .deck = loaded.deck.file(),
          .clocks = {},
          .remark = {}};
}

}  // namespace tether
