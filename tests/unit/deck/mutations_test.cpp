// SPDX-License-Identifier: GPL-3.0-or-later
// Every byte of every printed deck and particle file, left out or written twice: no crash, no exception, and errors
// that point into the text.
#include <gtest/gtest.h>

#include <algorithm>

#include "deck/document.hpp"
#include "deck/particle_file.hpp"
#include "deck_support.hpp"

namespace tether::test {
namespace {

void expect_places_in(const Diagnostics& diagnostics, int lines) {
  for (const auto& d : diagnostics.all()) {
    ASSERT_GE(d.place.line, 0);
    ASSERT_LE(d.place.line, lines + 1);
    ASSERT_LE(d.place.column, static_cast<int>(d.line_text.size()) + 1) << to_text(d);
  }
}

int line_count(const std::string& text) { return static_cast<int>(std::count(text.begin(), text.end(), '\n')) + 1; }

/// What still reads must survive deck.effective; one in sixteen is tried.
void read_mutated_deck(const std::string& text, std::size_t k) {
  const auto reading = read(text);
  expect_places_in(reading.diagnostics, line_count(text));
  if (k % 16 == 0 && !reading.diagnostics.has_errors()) {
    EXPECT_EQ(read(effective_deck(reading.deck)).errors(), Texts{}) << text;
  }
}

class MutatedBoxes : public testing::TestWithParam<std::string> {};

TEST_P(MutatedBoxes, WithoutOneByte) {
  const auto text = box_text(GetParam());
  for (std::size_t k = 0; k < text.size(); ++k) {
    auto mutated = text;
    read_mutated_deck(mutated.erase(k, 1), k);
  }
}

TEST_P(MutatedBoxes, WithOneByteTwice) {
  const auto text = box_text(GetParam());
  for (std::size_t k = 0; k < text.size(); ++k) {
    auto mutated = text;
    read_mutated_deck(mutated.insert(k, 1, text[k]), k);
  }
}

TEST_P(MutatedBoxes, CutOff) {
  const auto text = box_text(GetParam());
  for (std::size_t k = 0; k < text.size(); k += 4) read_mutated_deck(text.substr(0, k), k);
}

INSTANTIATE_TEST_SUITE_P(Thesis, MutatedBoxes, testing::ValuesIn(box_names()));

class MutatedParticles : public testing::TestWithParam<std::string> {};

TEST_P(MutatedParticles, WithoutOneByteAndWithOneTwice) {
  const auto text = box_text(GetParam());
  for (std::size_t k = 0; k < text.size(); ++k) {
    for (const bool twice : {false, true}) {
      auto mutated = text;
      twice ? mutated.insert(k, 1, text[k]) : mutated.erase(k, 1);
      Diagnostics diagnostics;
      const auto file = read_particle_file(mutated, "a.par", 1, diagnostics);
      expect_places_in(diagnostics, line_count(mutated));
      if (!diagnostics.has_errors()) {
        EXPECT_EQ(static_cast<int>(file.rows.size()), file.total);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Thesis, MutatedParticles,
                         testing::Values("box04_springmass.par", "box05_stringmass.par", "box07_pendulum.par",
                                         "box09_membrane.par", "box13_piston.par", "box14_stability.par"));

TEST(HostileDecks, AreReadInOnePass) {
  const std::size_t many = 100000;
  const std::string head = "$in ";
  std::string texts[] = {head + std::string(many, '('),
                         head + std::string(many, '\''),
                         head + std::string(many, '$'),
                         head + std::string(many, ','),
                         head + std::string(many, '='),
                         head + std::string(many, '*'),
                         std::string(many, '$'),
                         std::string(many, '\n'),
                         head + std::string(many, '\xa0'),
                         head + std::string(many, '\0'),
                         head + "iout=" + std::string(many, '9') + "*0",
                         head + "gravc=" + std::string(many, '9')};
  for (const auto& text : texts) EXPECT_TRUE(read(text).diagnostics.has_errors()) << text.substr(0, 10);
  std::string lines = head, items = head, counts = head;
  for (std::size_t k = 0; k < many / 10; ++k) {
    lines += "'''\n";
    items += "a(1 ";
    counts += "iout=60*1 ";
  }
  for (const auto& text : {lines, items, counts})
    EXPECT_TRUE(read(text).diagnostics.has_errors()) << text.substr(0, 10);
}

}  // namespace
}  // namespace tether::test
