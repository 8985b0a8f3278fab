// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.hpp"

namespace tether {

using RowNumbers = std::array<double, 7>;

/// Widths of a fused row, 2 fields of w1 characters and 5 of w2: (2Fw1, 5Fw2) as Fortran wrote it.
struct FusedLayout {
  std::size_t w1 = 0, w2 = 0;
};

/// The seven numbers of a row that blanks or commas part, else nothing.
std::optional<RowNumbers> list_row(std::string_view row);

/// The seven numbers of a fused row in a layout, where each field is one complete number with one '.', right-adjusted;
/// else nothing.
std::optional<RowNumbers> fused_row(std::string_view row, FusedLayout layout);

/// All layouts whose widths, 2 w1 + 5 w2, add up to a row's length, and in which it is seven numbers.
std::vector<FusedLayout> layouts_of(std::string_view row);

/// Returns whether a row could be a fused one: it has nothing but what numbers are written with.
bool looks_fused(std::string_view row);

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

/// Reads particle data. `first_line` is the number of the text's first line in `file` (particle data may stand after
/// the groups of a deck). Mistakes go into `diagnostics`.
/// Rows are list-directed where they split into exactly 7 numbers; else fused fixed-width: the one pair of widths
/// (w1, w2), 2 w1 + 5 w2 = length, that makes every fused row 7 complete numbers.
ParticleFile read_particle_file(std::string_view text, const std::string& file, int first_line,
                                Diagnostics& diagnostics);

}  // namespace tether
