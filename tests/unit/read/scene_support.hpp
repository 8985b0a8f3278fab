// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deck/reader.hpp"
#include "model/solids.hpp"
#include "read/build.hpp"
#include "read/points/points_group.hpp"

namespace tether::test {

/// A scene, and what was said about the deck and its particle data.
struct Built {
  Scene scene;
  Diagnostics diagnostics;

  /// "line:column: message" of each error.
  std::vector<std::string> errors() const {
    std::vector<std::string> texts;
    for (const auto& d : diagnostics.errors()) {
      texts.push_back(std::to_string(d.place.line) + ":" + std::to_string(d.place.column) + ": " + d.message);
    }
    return texts;
  }
};

inline Built build(const std::string& text, const std::vector<std::string>& overrides = {}) {
  Built built;
  const Deck deck = read_deck(text, "a.in", overrides, built.diagnostics);
  const auto particles = load_particles(deck, std::nullopt, built.diagnostics);
  built.scene = build_scene(deck, particles, Path::mpm, built.diagnostics);
  return built;
}

/// Of a deck with a mesh, which has no particle file.
inline Built build_on_mesh(const std::string& text) {
  Built built;
  const Deck deck = read_deck(text, "a.in", {}, built.diagnostics);
  built.scene = build_scene(deck, std::nullopt, Path::fem, built.diagnostics);
  return built;
}

/// $in of a grid of 4 x 4 cells on the unit square, on lines 1 and 2; `rest` closes the group and begins on line 3.
inline std::string on_unit_square(const std::string& rest) {
  return "$in\nnx=5,ny=5,xleft=0.,xright=1.,ybot=0.,ytop=1.,tmax=2.,tstep=.01\n" + rest;
}

/// The middle four cells as region 1, of density 3 in plane strain; `in` is line 3 and `reg` line 10.
inline std::string square_region(const std::string& in = "", const std::string& reg = "") {
  return on_unit_square(in + "\n$\n$reg\nnreg=1,nvi=4\nxvi(1,1)=.25,.75,.75,.25\nyvi(1,1)=.25,.25,.75,.75\n" +
                        "densir=3.,ipath(4,1)=0,matr(1,1)=10.,.25\n" + reg + "\n$\n");
}

/// $in with igen, then `groups` from line 5 on, then file 2 behind the groups: a string of three points.
inline std::string string_deck(const std::string& groups = "", const std::string& in = "igen=0") {
  return on_unit_square(in + "\n$\n" + groups +
                        "0.5 ! density\n100.,.3,0.,0.,0.,0.,0.\n3,3,3,8\n3\n3,2\n"
                        ".125 .5  1. 2. 3. 4. 5.\n.375 .5  0. 0. 0. 0. 0.\n.625 .5 -1. 0. 0. 0. 0.\n");
}

/// The same, at rest.
inline std::string resting_string_deck(const std::string& groups, const std::string& in) {
  std::string deck = string_deck(groups, in);
  deck.replace(deck.find(".5  1. 2."), 9, ".5  0. 0.");
  return deck.replace(deck.find(".5 -1. 0."), 9, ".5  0. 0.");
}

using Texts = std::vector<std::string>;

inline Texts warnings_of(const Built& built) {
  Texts texts;
  for (const auto& d : built.diagnostics.warnings()) texts.push_back(d.message);
  return texts;
}

}  // namespace tether::test
