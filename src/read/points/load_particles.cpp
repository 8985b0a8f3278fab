// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/points/load_particles.hpp"

#include <fmt/format.h>

#include "base/errors.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "read/named_file.hpp"
#include "read/points/membrane_curves.hpp"

namespace tether {
namespace {

namespace fs = std::filesystem;

/// Nothing where not even its header could be read: what would be said of its points has no ground.
std::optional<ParticleFile> read_text(const std::string& text, const std::string& file, int first_line,
                                      Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.errors().size();
  ParticleFile read = read_particle_file(text, file, first_line, diagnostics);
  if (read.rows.empty() && diagnostics.errors().size() > errors_before) return std::nullopt;
  return read;
}

std::optional<ParticleFile> read_path(const fs::path& path, const Diagnostic& missing, Diagnostics& diagnostics) {
  try {
    return read_text(read_file(path), path.string(), 1, diagnostics);
  } catch (const FileError& error) {
    Diagnostic diagnostic = missing;
    diagnostic.message = fmt::format("particle file: {}", error.what());
    diagnostics.add(diagnostic);
    return std::nullopt;
  }
}

std::optional<ParticleFile> read_named(const Deck& deck, const std::string& name, Diagnostics& diagnostics) {
  const std::string mistake = path_mistake(name);
  if (!mistake.empty()) {
    diagnostics.add(deck.remark(Severity::error, "in", "particles", {1, 1}, "the particle path " + mistake,
                                path_hint("../particles/x.par") + ", or use --particles FILE"));
    return std::nullopt;
  }
  return read_path(
      path_beside(deck, name),
      deck.remark(Severity::error, "in", "particles", {1, 1}, "", "the path counts from the deck's folder"),
      diagnostics);
}

}  // namespace

std::optional<ParticleFile> load_particles(const Deck& deck, const std::optional<fs::path>& given,
                                           Diagnostics& diagnostics) {
  const int igen = deck.integer("in", "igen");
  if (igen == 1) {
    if (given)
      diagnostics.add(deck.remark(Severity::warning, "in", "igen", {1, 1},
                                  "igen = 1 reads no particle file: --particles is not used"));
    return std::nullopt;
  }
  if (given) {
    Diagnostic missing;
    missing.hint = "named by --particles";
    return read_path(*given, missing, diagnostics);
  }
  const std::string name = deck.text("in", "particles");
  if (!name.empty()) return read_named(deck, name, diagnostics);
  if (!trim(deck.trailer().text).empty()) {
    return read_text(deck.trailer().text, deck.file(), deck.trailer().first_line, diagnostics);
  }
  if (igen == 3 && gives_curves(deck)) return std::nullopt;
  const char* last =
      igen == 3 ? "use --particles FILE, or give membranes by $membrane curve" : "or use --particles FILE";
  diagnostics.add(deck.remark(Severity::error, "in", "igen", {1, 1},
                              fmt::format("igen = {} takes points from a particle file, and none is named", igen),
                              fmt::format("add particles='../particles/x.par' to $in, put the data behind the last "
                                          "group, {}",
                                          last)));
  return std::nullopt;
}

}  // namespace tether
