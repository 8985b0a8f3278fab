// SPDX-License-Identifier: GPL-3.0-or-later
// Particle data behind the groups of a deck, where deck.effective puts them.
#include <gtest/gtest.h>

#include "deck/document.hpp"
#include "deck/particle_file.hpp"
#include "deck_support.hpp"

namespace tether::test {
namespace {

const Texts data{"0.1 ! density", "1.,0.,0.,0.,0.,0.,0.", "3,3,3,8", "1", "1,3", "1. 2. 0. 0. 0. 0. 0."};

std::string joined(const Texts& lines) {
  std::string text;
  for (const auto& line : lines) text += line + "\n";
  return text;
}

TEST(ParticleData, StandInPlaceOfTheFileThatTheDeckNames) {
  const auto deck = read(with_in("igen=0 particles='a.par'\n$\nold data\n")).deck;
  const auto with_data = deck.with_particle_data(data);
  EXPECT_EQ(with_data.text("in.particles"), "");
  EXPECT_EQ(with_data.trailer().text, joined(data));
  EXPECT_EQ(with_data.integer("in.igen"), 0);
  EXPECT_EQ(deck.text("in.particles"), "a.par");
  EXPECT_EQ(deck.trailer().text, "old data\n");
}

TEST(ParticleData, ReadBackFromTheEffectiveDeck) {
  const auto again = read(effective_deck(read(with_in("igen=0\n$\n")).deck.with_particle_data(data)));
  ASSERT_EQ(again.errors(), Texts{});
  Diagnostics diagnostics;
  const auto& trailer = again.deck.trailer();
  const auto file = read_particle_file(trailer.text, "a.in", trailer.first_line, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  ASSERT_EQ(file.rows.size(), 1U);
  EXPECT_EQ(file.rows[0].y, 2.0);
  EXPECT_EQ(file.rows[0].line, trailer.first_line + 5);
}

TEST(ParticleData, NotesBehindThemOpenNoGroup) {
  const auto deck = read(with_in("igen=0\n$\n")).deck;
  for (const char* opener : {"$in", " & in nx=3", "$points 1", "&pendulum,"}) {
    auto noted = data;
    noted.insert(noted.end(), {"40 points for the pendulum", opener, data.back()});
    const auto effective = effective_deck(deck.with_particle_data(noted));
    EXPECT_EQ(read(effective).errors(), Texts{}) << opener;
    EXPECT_TRUE(effective.ends_with(data.back() + "\n40 points for the pendulum\n")) << effective;
  }
}

TEST(ParticleData, LinesAreNumberedAsInTheirFile) {
  Diagnostics diagnostics;
  const auto file = read_particle_file(joined(data), "a.in", 48, diagnostics);
  EXPECT_EQ(line_text(file, 48), "0.1 ! density");
  EXPECT_EQ(line_text(file, file.ipath_line), "3,3,3,8");
  EXPECT_EQ(line_text(file, 53), data.back());
  EXPECT_EQ(line_text(file, 54), "");
  EXPECT_EQ(line_text(file, 47), "");
}

}  // namespace
}  // namespace tether::test
