// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.hpp"

namespace tether {

/// A row of a particle file: position, velocity, stress.
struct ParticleRow {
  double x = 0, y = 0, vx = 0, vy = 0, sxx = 0, syy = 0, sxy = 0;
  int line = 0;  ///< in its file, from 1
};

/// "File 2" of the thesis: one body given point by point.
struct ParticleFile {
  std::string file;
  double density = 0;
  std::array<double, 7> constants{};       ///< as matr(1..7) of a region
  int constants_line = 0, ipath_line = 0;  ///< where these two stand
  std::array<int, 4> ipath{};              ///< the fourth decides the law
  int in_sequence = 0;                     ///< points in the sequence
  int total = 0;                           ///< rows declared
  double per_cell = 0;                     ///< np2: points that share a cell's volume, not always whole
  std::vector<ParticleRow> rows;
  std::vector<std::string> lines;  ///< the text, for later remarks: a row's is lines[row.line - first_line]
  int first_line = 1;              ///< number of lines[0] in `file`
};

/// The text of a line of the file, for diagnostics.
std::string line_text(const ParticleFile& file, int line);

/// Reads particle data. `first_line` is the number of the text's first line in `file` (particle data may stand behind
/// the groups of a deck). Mistakes go into `diagnostics`.
/// Rows are list-directed where they split into exactly 7 numbers; else fused fixed-width: the one pair of widths
/// (w1, w2), 2 w1 + 5 w2 = length, that makes every fused row 7 complete numbers.
ParticleFile read_particle_file(std::string_view text, const std::string& file, int first_line,
                                Diagnostics& diagnostics);

}  // namespace tether
