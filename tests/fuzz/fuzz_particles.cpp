// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a particle file; and again as the data behind the groups of a deck, where deck.effective puts them.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "deck/document.hpp"
#include "deck/particle_file.hpp"
#include "deck/reader.hpp"
#include "fuzz/properties.hpp"

namespace tether::fuzz {
namespace {

constexpr std::string_view deck_text =
    "$in\nnx=11,ny=21,xleft=0.,xright=1.,ybot=0.,ytop=2.,tmax=1.,tstep=.1,igen=0\n$\n";

RowNumbers numbers_of(const ParticleRow& row) { return {row.x, row.y, row.vx, row.vy, row.sxx, row.syy, row.sxy}; }

bool same_bits(const ParticleRow& a, const ParticleRow& b) {
  return std::bit_cast<std::array<std::uint64_t, 7>>(numbers_of(a)) ==
         std::bit_cast<std::array<std::uint64_t, 7>>(numbers_of(b));
}

void expect_consistent(const ParticleFile& file) {
  expect(file.rows.size() == static_cast<std::size_t>(file.total), "there are as many rows as declared");
  expect(file.density > 0 && file.per_cell > 0, "density and points per cell are positive");
  for (const auto& row : file.rows) {
    const auto numbers = numbers_of(row);
    expect(std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); }),
           "the numbers of a row are finite");
    expect(!line_text(file, row.line).empty(), "a row has its line");
  }
}

void expect_survives_behind_a_deck(const ParticleFile& file) {
  Diagnostics diagnostics;
  const auto deck = read_deck(deck_text, "a.in", {}, diagnostics).with_particle_data(file.lines);
  expect_survives(deck);
  const auto again = read_deck(effective_deck(deck), "deck.effective", {}, diagnostics);
  const auto& trailer = again.trailer();
  const auto data = read_particle_file(trailer.text, "deck.effective", trailer.first_line, diagnostics);
  for (const auto& error : diagnostics.errors()) expect(false, "the data read behind a deck: " + to_text(error));
  expect(std::equal(file.rows.begin(), file.rows.end(), data.rows.begin(), data.rows.end(), same_bits),
         "the rows are the same behind a deck");
}

}  // namespace
}  // namespace tether::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  tether::Diagnostics diagnostics;
  const auto file = tether::read_particle_file(text, "a.par", 1, diagnostics);
  tether::fuzz::expect_places_inside(diagnostics, file.lines);
  if (diagnostics.has_errors()) return 0;
  tether::fuzz::expect_consistent(file);
  tether::fuzz::expect_survives_behind_a_deck(file);
  return 0;
}
