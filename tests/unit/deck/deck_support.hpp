// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/file.hpp"
#include "deck/reader.hpp"

namespace tether::test {

/// A deck as read, and what was said about it.
struct Reading {
  Deck deck;
  Diagnostics diagnostics;

  /// "line:column: message" of each error, each remark, or all that is no error.
  std::vector<std::string> errors() const { return short_texts(diagnostics.errors()); }
  std::vector<std::string> remarks() const { return short_texts(diagnostics.remarks()); }
  std::vector<std::string> warnings() const {
    std::vector<Diagnostic> all = diagnostics.all();
    std::erase_if(all, [](const Diagnostic& diagnostic) { return diagnostic.severity == Severity::error; });
    return short_texts(all);
  }

 private:
  static std::vector<std::string> short_texts(const std::vector<Diagnostic>& diagnostics) {
    std::vector<std::string> texts;
    for (const auto& d : diagnostics) {
      texts.push_back(std::to_string(d.place.line) + ":" + std::to_string(d.place.column) + ": " + d.message);
    }
    return texts;
  }
};

inline Reading read(const std::string& text, const std::vector<std::string>& overrides = {}) {
  Diagnostics diagnostics;
  Deck deck = read_deck(text, "a.in", overrides, diagnostics);
  return {std::move(deck), std::move(diagnostics)};
}

/// All that $in must have, on lines 1 and 2; what follows begins on line 3.
inline std::string with_in(const std::string& rest) {
  return "$in\nnx=11,ny=21,xleft=0.,xright=1.,ybot=0.,ytop=2.,tmax=1.,tstep=.1\n" + rest;
}

/// Items of $in, from line 3 on.
inline Reading read_in(const std::string& items) { return read(with_in(items + "\n$\n")); }

/// Items of $reg, from line 5 on.
inline Reading read_reg(const std::string& items) { return read(with_in("$\n$reg\n" + items + "\n$\n")); }

inline std::filesystem::path tests_folder() { return std::filesystem::path(TETHER_SOURCE_DIR) / "tests"; }

inline std::string box_text(const std::string& name) { return read_file(tests_folder() / "thesis-boxes" / name); }

inline const std::vector<std::string>& box_names() {
  static const std::vector<std::string> names{"box01_sod.in",       "box02_gasexp.in",  "box03_springmass.in",
                                              "box06_pendulum.in",  "box08_ballnet.in", "box09_membrane.in",
                                              "box10_cyl200.in",    "box11_cyl500.in",  "box12_piston.in",
                                              "box14_stability.in", "box15_twobar.in",  "box16_ballnet_orig.in"};
  return names;
}

using Texts = std::vector<std::string>;

}  // namespace tether::test
