// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/points/points_group.hpp"

#include <gtest/gtest.h>

#include "base/file.hpp"
#include "deck/reader.hpp"
#include "unit/temporary_folder.hpp"

namespace tether::test {
namespace {

namespace fs = std::filesystem;

std::string in_group(const std::string& items) {
  return "$in\nnx=5,ny=5,xleft=0.,xright=1.,ybot=0.,ytop=1.,tmax=2.,tstep=.01\n" + items + "\n$\n";
}

/// Particle data of one point at (x, .5), to tell files apart.
std::string one_point(const std::string& x) { return "1.\n1,0,0,0,0,0,0\n3,3,3,0\n1\n1,1\n" + x + " .5 0 0 0 0 0\n"; }

/// A folder with decks/sub/a.in, and particle files beside the deck, one and two folders up, and below.
class LoadParticles : public TemporaryFolder {
 protected:
  void SetUp() override {
    fs::create_directories(folder / "decks" / "sub" / "below");
    write_file(folder / "decks" / "sub" / "beside.par", one_point(".1"));
    write_file(folder / "decks" / "sub" / "below" / "below.par", one_point(".2"));
    write_file(folder / "decks" / "up.par", one_point(".3"));
    write_file(folder / "two_up.par", one_point(".4"));
  }
  std::optional<ParticleFile> load(const std::string& text, const std::optional<fs::path>& given = std::nullopt) {
    const Deck deck = read_deck(text, (folder / "decks" / "sub" / "a.in").string(), {}, diagnostics);
    return load_particles(deck, given, diagnostics);
  }
  std::optional<ParticleFile> load_named(const std::string& name) {
    return load(in_group("igen=0,particles='" + name + "'"));
  }
  void expect_error(int line, int column, const std::string& message) const {
    const auto errors = diagnostics.errors();
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(errors[0].place.line, line);
    EXPECT_EQ(errors[0].place.column, column);
    EXPECT_EQ(errors[0].message, message);
  }
  Diagnostics diagnostics;
};

TEST_F(LoadParticles, FromTheDecksFolderBelowItOrOneUp) {
  EXPECT_EQ(load_named("beside.par").value().rows.at(0).x, .1);
  EXPECT_EQ(load_named("./below/below.par").value().rows.at(0).x, .2);
  EXPECT_EQ(load_named("../up.par").value().rows.at(0).x, .3);
  EXPECT_EQ(load_named("below/../../up.par").value().rows.at(0).x, .3);
  EXPECT_FALSE(diagnostics.has_errors());
}

TEST_F(LoadParticles, RefusesAnAbsolutePath) {
  EXPECT_FALSE(load_named("/etc/passwd").has_value());
  expect_error(3, 18, "the particle path is absolute");
}

TEST_F(LoadParticles, RefusesToClimbTwoFolders) {
  EXPECT_FALSE(load_named("../../two_up.par").has_value());
  expect_error(3, 18, "the particle path climbs more than one folder");
}

TEST_F(LoadParticles, RefusesADetourThatClimbsTwoFolders) {
  EXPECT_FALSE(load_named("below/../../../two_up.par").has_value());
  expect_error(3, 18, "the particle path climbs more than one folder");
}

TEST_F(LoadParticles, RefusesToClimbAndComeBack) {
  EXPECT_FALSE(load_named("../../decks/up.par").has_value());
  expect_error(3, 18, "the particle path climbs more than one folder");
}

TEST_F(LoadParticles, AMissingFileIsNamedAtTheDecksPlace) {
  EXPECT_FALSE(load_named("none.par").has_value());
  expect_error(3, 18,
               "particle file: " + (folder / "decks/sub/none.par").string() +
                   ": cannot be opened for reading: No such file or directory");
}

TEST_F(LoadParticles, AFolderIsNoFile) {
  EXPECT_FALSE(load_named("below").has_value());
  expect_error(3, 18, "particle file: " + (folder / "decks/sub/below").string() + ": cannot be read: Is a directory");
}

TEST_F(LoadParticles, TheCommandLineNamesAnyPathAndWins) {
  EXPECT_EQ(load(in_group("igen=0,particles='beside.par'"), folder / "two_up.par").value().rows.at(0).x, .4);
  EXPECT_EQ(load(in_group("igen=3") + one_point(".9"), folder / "two_up.par").value().rows.at(0).x, .4);
  EXPECT_FALSE(diagnostics.has_errors());
}

TEST_F(LoadParticles, AMissingFileOfTheCommandLine) {
  EXPECT_FALSE(load(in_group("igen=0"), folder / "none.par").has_value());
  expect_error(
      0, 0,
      "particle file: " + (folder / "none.par").string() + ": cannot be opened for reading: No such file or directory");
}

TEST_F(LoadParticles, FromBehindTheDecksGroups) {
  const auto file = load(in_group("igen=3") + one_point(".7"));
  ASSERT_TRUE(file.has_value());
  EXPECT_EQ(file->rows.at(0).x, .7);
  EXPECT_EQ(file->rows.at(0).line, 10);  // of the deck
  EXPECT_EQ(file->file, (folder / "decks/sub/a.in").string());
}

TEST_F(LoadParticles, ANamedFileWinsOverTheDataBehindTheGroups) {
  EXPECT_EQ(load(in_group("igen=0,particles='../up.par'") + one_point(".7")).value().rows.at(0).x, .3);
}

TEST_F(LoadParticles, NothingIsNamed) {
  EXPECT_FALSE(load(in_group("igen=0")).has_value());
  expect_error(3, 6, "igen = 0 takes points from a particle file, and none is named");
}

TEST_F(LoadParticles, Igen1ReadsNoneAndSaysSoWhereOneIsGiven) {
  EXPECT_FALSE(load(in_group("igen=1,particles='none.par'")).has_value());
  EXPECT_TRUE(diagnostics.all().empty());
  EXPECT_FALSE(load(in_group("igen=1"), folder / "none.par").has_value());
  ASSERT_EQ(diagnostics.warnings().size(), 1u);
  EXPECT_EQ(diagnostics.warnings()[0].message, "igen = 1 reads no particle file: --particles is not used");
  EXPECT_FALSE(diagnostics.has_errors());
}

TEST_F(LoadParticles, MistakesInAFileStandAtItsOwnLines) {
  write_file(folder / "bad.par", "-1.\n1,0,0,0,0,0,0\n3,3,3,0\n1\n1,1\n.1 .5 0 0 0 0 0\n");
  load(in_group("igen=0"), folder / "bad.par");
  const auto errors = diagnostics.errors();
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].place.file, (folder / "bad.par").string());
  EXPECT_EQ(errors[0].place.line, 1);
  EXPECT_EQ(errors[0].message, "the density must be > 0, not -1");
}

}  // namespace
}  // namespace tether::test
