// SPDX-License-Identifier: GPL-3.0-or-later
// Every deck of tests/bad_decks that fails while it is read: its second line says which message must appear.
#include <gtest/gtest.h>

#include <algorithm>

#include "deck/particle_file.hpp"
#include "deck_support.hpp"

namespace tether::test {
namespace {

constexpr std::string_view expected_here = "expect: ";
constexpr std::string_view expected_of_particles = "expect-scene: ";

std::vector<std::string> files_with(const std::string& extension) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(tests_folder() / "bad_decks")) {
    if (entry.path().extension() == extension) names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string bad_text(const std::string& name) { return read_file(tests_folder() / "bad_decks" / name); }

std::string all_of(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const auto& diagnostic : diagnostics) text += to_text(diagnostic);
  return text;
}

class BadDecks : public testing::TestWithParam<std::string> {};

TEST_P(BadDecks, SayWhatIsWrong) {
  const auto reading = read(bad_text(GetParam() + ".in"));
  ASSERT_GE(reading.deck.header().size(), 2U);
  const std::string_view second = reading.deck.header()[1];
  if (!second.starts_with(expected_here)) {
    // Its mistake is found later: it must read.
    EXPECT_EQ(reading.errors(), Texts{});
    return;
  }
  const auto errors = reading.diagnostics.errors();
  ASSERT_FALSE(errors.empty());
  EXPECT_NE(all_of(errors).find(second.substr(expected_here.size())), std::string::npos) << all_of(errors);
}

INSTANTIATE_TEST_SUITE_P(Deck, BadDecks, testing::ValuesIn(files_with(".in")),
                         [](const auto& test) { return test.param; });

class BadParticles : public testing::TestWithParam<std::string> {};

TEST_P(BadParticles, SayWhatIsWrong) {
  Diagnostics diagnostics;
  read_particle_file(bad_text(GetParam() + ".par"), "a.par", 1, diagnostics);
  const std::string second = read(bad_text(GetParam() + ".in")).deck.header().at(1);
  ASSERT_TRUE(second.starts_with(expected_of_particles));
  const auto errors = diagnostics.errors();
  EXPECT_NE(all_of(errors).find(second.substr(expected_of_particles.size())), std::string::npos) << all_of(errors);
}

INSTANTIATE_TEST_SUITE_P(Deck, BadParticles,
                         testing::Values("particles_ambiguous", "particles_bad_row", "particles_long",
                                         "particles_short", "particles_zero_density"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace tether::test
