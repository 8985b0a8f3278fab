// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/mesh/load_mesh.hpp"

#include <fmt/format.h>

#include "base/errors.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "read/named_file.hpp"

namespace tether {

Deck load_mesh(const Deck& deck, Diagnostics& diagnostics) {
  const std::string name = deck.text("mesh", "file");
  if (name.empty()) return deck;
  const auto error = [&](const char* variable, const std::string& message, const std::string& hint) {
    diagnostics.add(deck.remark(Severity::error, "mesh", variable, {1, 1}, message, hint));
    return deck;
  };
  if (const std::string mistake = path_mistake(name); !mistake.empty())
    return error("file", "the mesh path " + mistake, path_hint("../meshes/x.msh"));
  try {
    Deck whole = deck.with_mesh_text(read_file(path_beside(deck, name)));
    const std::string meant = deck.text("mesh", "file_sha256");
    if (meant.empty() || meant == sha256(*whole.mesh_text())) return whole;
    return error(
        "file_sha256",
        fmt::format("'{}' is not the mesh file that was meant: its SHA-256 is {}", name, sha256(*whole.mesh_text())),
        "It was changed. Leave file_sha256 away to take it as it is.");
  } catch (const FileError& reason) {
    return error("file", fmt::format("mesh file: {}", reason.what()), "the path counts from the deck's folder");
  }
}

}  // namespace tether
