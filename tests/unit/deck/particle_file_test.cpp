// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/particle_file.hpp"

#include <gtest/gtest.h>

#include "deck_support.hpp"

namespace tether::test {
namespace {

struct Particles {
  ParticleFile file;
  Diagnostics diagnostics;

  /// "line:column: message" of each error.
  Texts errors() const {
    Texts texts;
    for (const auto& d : diagnostics.errors()) {
      texts.push_back(std::to_string(d.place.line) + ":" + std::to_string(d.place.column) + ": " + d.message);
    }
    return texts;
  }
};

Particles particles(const std::string& text, int first_line = 1) {
  Diagnostics diagnostics;
  auto file = read_particle_file(text, "a.par", first_line, diagnostics);
  return {std::move(file), std::move(diagnostics)};
}

/// A sound head on lines 1-5, then rows from line 6 on.
std::string with_head(int rows, const std::string& text) {
  return "0.1\n1.d6,0.,0.,0.,0.,0.,0.\n3,3,3,8\n" + std::to_string(rows) + "\n" + std::to_string(rows) + ",3\n" + text;
}

std::vector<double> numbers(const ParticleRow& row) {
  return {row.x, row.y, row.vx, row.vy, row.sxx, row.syy, row.sxy};
}

using Reals = std::vector<double>;

TEST(ParticleFile, FusedRowsOfBox4) {
  const auto read = particles(box_text("box04_springmass.par"));
  EXPECT_EQ(read.errors(), Texts{});
  EXPECT_EQ(read.file.density, 0.1);
  EXPECT_EQ(read.file.constants, (std::array<double, 7>{1e6, 0, 1e26, 2e25, 1e25, 100, 0}));
  EXPECT_EQ(read.file.ipath, (std::array<int, 4>{3, 3, 3, 8}));
  EXPECT_EQ(read.file.in_sequence, 10);
  EXPECT_EQ(read.file.total, 10);
  EXPECT_EQ(read.file.per_cell, 3.0);
  ASSERT_EQ(read.file.rows.size(), 10U);
  EXPECT_EQ(numbers(read.file.rows[0]), (Reals{0.05, 1.99, 0, 0, 0, 0, 0}));
  EXPECT_EQ(numbers(read.file.rows[9]), (Reals{0.05, 1.69, 0, 0, 0, 0, 0}));
  EXPECT_EQ(read.file.rows[9].line, 15);
  EXPECT_EQ(read.file.lines[14], "0.0500001.6900000.000.000.000.000.00");
}

TEST(ParticleFile, ExponentsInRowsOfBox5) {
  const auto read = particles(box_text("box05_stringmass.par"));
  EXPECT_EQ(read.errors(), Texts{});
  ASSERT_EQ(read.file.rows.size(), 10U);
  EXPECT_EQ(numbers(read.file.rows[3]), (Reals{0.05, 1.89, 0, 0, 0, -1e5, 0}));
  EXPECT_EQ(read.file.rows[9].syy, 0.0);
}

TEST(ParticleFile, PartlyFusedRowsAndTheNoteBehindThemInBox7) {
  const auto read = particles(box_text("box07_pendulum.par"));
  EXPECT_EQ(read.errors(), Texts{});
  EXPECT_EQ(read.file.per_cell, 3.03);
  ASSERT_EQ(read.file.rows.size(), 40U);
  EXPECT_EQ(numbers(read.file.rows[0]), (Reals{0.33333, 0.9999, 0, 0, 0, 0, 0}));
  EXPECT_EQ(numbers(read.file.rows[39]), (Reals{0.101, 0.303, 0, 0, 0, 0, 0}));
}

TEST(ParticleFile, TheOnePrintedRowOfBox9) {
  const auto read = particles(box_text("box09_membrane.par"), 48);
  EXPECT_EQ(read.errors(), (Texts{"0:0: 600 rows declared, 1 found"}));
  EXPECT_EQ(read.file.per_cell, 6.8207);
  ASSERT_EQ(read.file.rows.size(), 1U);
  EXPECT_EQ(numbers(read.file.rows[0]), (Reals{0.49999, 0.00111, 0, 0, 0, 0, 0}));
  EXPECT_EQ(read.file.rows[0].line, 53);
  EXPECT_EQ(read.file.first_line, 48);
}

TEST(ParticleFile, ListedRowsOfBoxes13And14) {
  const auto piston = particles(box_text("box13_piston.par"));
  EXPECT_EQ(piston.errors(), Texts{});
  EXPECT_EQ(piston.file.constants[0], 2010.0);
  ASSERT_EQ(piston.file.rows.size(), 20U);
  EXPECT_EQ(numbers(piston.file.rows[19]), (Reals{0.5, 20.5, 0, -1, 0, 0, 0}));
  const auto stability = particles(box_text("box14_stability.par"));
  EXPECT_EQ(stability.errors(), Texts{});
  EXPECT_EQ(stability.file.ipath[3], 0);
  EXPECT_EQ(stability.file.rows.at(2).vx, 1e-8);
}

TEST(ParticleFile, BlankLinesCommentsAndLineEnds) {
  const auto read = particles(
      "\xef\xbb\xbf\r\n! head\r\n0.1 ! density\r\n1.d6 0 0 0 0 0 0\r\n3 3 3 8\r\n\r\n1\r\n1, 2.5\r\n"
      "! rows\r\n\t1,2, 0 0 0;0\t0 ! first\r\n\r\nnotes");
  EXPECT_EQ(read.errors(), Texts{});
  ASSERT_EQ(read.file.rows.size(), 1U);
  EXPECT_EQ(numbers(read.file.rows[0]), (Reals{1, 2, 0, 0, 0, 0, 0}));
  EXPECT_EQ(read.file.rows[0].line, 10);
}

TEST(ParticleFile, FusedNegativeNumbersAndLeadingBlanks) {
  const auto read = particles(with_head(2, " 0.50-1.25 0.0-1.0 0.0 0.0 0.0\n-0.50 1.25-2.0 0.0 0.0 0.0 9.5\n"));
  EXPECT_EQ(read.errors(), Texts{});
  ASSERT_EQ(read.file.rows.size(), 2U);
  EXPECT_EQ(numbers(read.file.rows[0]), (Reals{0.5, -1.25, 0, -1, 0, 0, 0}));
  EXPECT_EQ(numbers(read.file.rows[1]), (Reals{-0.5, 1.25, -2, 0, 0, 0, 9.5}));
}

TEST(ParticleFile, FusedAndListedRowsMix) {
  const auto read = particles(with_head(2, "0.5 0.25 0. 0. 0. -1.d5 0.\n0.0500001.9900000.000.000.000.000.00\n"));
  EXPECT_EQ(read.errors(), Texts{});
  EXPECT_EQ(read.file.rows.at(0).syy, -1e5);
  EXPECT_EQ(read.file.rows.at(1).y, 1.99);
}

struct WrongParticleFile {
  std::string text;
  Texts errors;
};

void PrintTo(const WrongParticleFile& wrong, std::ostream* out) { *out << wrong.text; }

class WrongParticles : public testing::TestWithParam<WrongParticleFile> {};

TEST_P(WrongParticles, AreToldWithTheirPlace) { EXPECT_EQ(particles(GetParam().text).errors(), GetParam().errors); }

const std::string row = "1. 2. 0. 0. 0. 0. 0.\n";
const std::string constants = "1.,0.,0.,0.,0.,0.,0.\n";

INSTANTIATE_TEST_SUITE_P(
    Rows, WrongParticles,
    testing::Values(
        WrongParticleFile{with_head(2, row), {"0:0: 2 rows declared, 1 found"}},
        WrongParticleFile{with_head(1, row + row + row + "note"), {"7:1: 1 rows declared, 3 found"}},
        WrongParticleFile{with_head(3, row + row + "40 mp for pendulum swing\n"), {"8:1: 3 rows declared, 2 found"}},
        WrongParticleFile{with_head(3, row + "1. 2. 0. 0. 0.x 0. 0.\n" + row), {"7:1: 3 rows declared, 1 found"}},
        WrongParticleFile{with_head(100000000, row), {"0:0: 100000000 rows declared, 1 found"}},
        WrongParticleFile{with_head(1, "1. 2. 0. 0. 0. 0.\n"), {"6:1: this row is not 7 numbers"}},
        WrongParticleFile{with_head(1, "1. 2. 0. 0. 0. 0. 0. 0.\n"), {"6:1: this row is not 7 numbers"}},
        WrongParticleFile{with_head(2, "0.0500001.9900000.000.000.000.000.00\n0.050001.990000.000.000.000.000.00\n"),
                          {"7:1: this row is not 7 numbers"}},
        WrongParticleFile{with_head(1, "0.500.250.00.00.00.00.00\n"), {"6:1: this row is not 7 numbers"}},
        WrongParticleFile{with_head(1, "1. 2. 0. 1e999 0. 0. 0.\n"), {"6:1: this row has a number that is not finite"}},
        WrongParticleFile{with_head(1, "1. 2. 0. nan 0. 0. 0.\n"), {"6:1: this row has a number that is not finite"}},
        WrongParticleFile{with_head(2, ".5.5.5.5.5.5.5\n.6.6.6.6.6.6.6\n"), {}},
        WrongParticleFile{with_head(1, std::string(300, '.') + "\n"), {"6:1: 1 rows declared, 0 found"}}));

INSTANTIATE_TEST_SUITE_P(
    Heads, WrongParticles,
    testing::Values(
        WrongParticleFile{"", {"0:0: the file is empty"}},
        WrongParticleFile{"0.1\n", {"0:0: the particle data end before 7 material constants"}},
        WrongParticleFile{"0.1\n" + constants, {"0:0: the particle data end before 4 integers ipath"}},
        WrongParticleFile{"0.1\n" + constants + "3,3,3,8\n",
                          {"0:0: the particle data end before the number of points in the sequence"}},
        WrongParticleFile{"0.1\n" + constants + "3,3,3,8\n1\n",
                          {"0:0: the particle data end before the number of points in all and the number per cell"}},
        WrongParticleFile{"notes on this problem\n", {"1:1: this line of the particle data must be the density"}},
        WrongParticleFile{"inf\n", {"1:1: this line of the particle data must be the density"}},
        WrongParticleFile{"0.1\n1.,0.\n", {"2:1: this line of the particle data must be 7 material constants"}},
        WrongParticleFile{"0.1\n" + constants + "3,3,8\n",
                          {"3:1: this line of the particle data must be 4 integers ipath"}},
        WrongParticleFile{"-0.1\n" + constants + "3,3,3,.5\n0\n0,0\n",
                          {"1:1: the density must be > 0, not -0.1",
                           "3:1: ipath must be a whole number from -100000000 to 100000000, not 0.5",
                           "5:1: the number of points in all must be a whole number from 1 to 100000000, not 0",
                           "5:1: the points per cell must be > 0, not 0"}},
        WrongParticleFile{
            "0.1\n" + constants + "3,3,3,8\n-1\n1e9,1\n",
            {"4:1: the number of points in the sequence must be a whole number from 0 to 100000000, not -1",
             "5:1: the number of points in all must be a whole number from 1 to 100000000, not 1000000000"}}));

/// 77 digits with a '.' in each field of (2F11,5F11), and of (2F6,5F13).
std::string ambiguous_row() {
  std::string text(77, '1');
  for (const std::size_t dot : {3, 11, 23, 35, 47, 60, 70}) text[dot] = '.';
  return text + "\n";
}

TEST(ParticleFile, RowsThatFitTwoLayoutsAreAmbiguous) {
  EXPECT_EQ(particles(with_head(2, ambiguous_row() + ambiguous_row())).errors(),
            (Texts{"6:1: the rows are run together and can be read in more than one way: (2F11,5F11) and (2F6,5F13)"}));
}

TEST(ParticleFile, ARowThatFitsOneLayoutOnlySettlesTheOthers) {
  auto settled = ambiguous_row();
  std::swap(settled[23], settled[21]);  // now the third field of (2F11,5F11) has no '.'
  const auto read = particles(with_head(2, ambiguous_row() + settled));
  EXPECT_EQ(read.errors(), Texts{});
  EXPECT_EQ(read.file.rows.at(0).x, 111.11);
  EXPECT_EQ(read.file.rows.at(0).y, 11111.0);
}

TEST(ParticleFile, HintsNameTheLayoutOfTheRowsBefore) {
  const auto read =
      particles(with_head(2, "0.0500001.9900000.000.000.000.000.00\n0.050001.990000.000.000.000.000.00\n"));
  ASSERT_EQ(read.errors().size(), 1U);
  EXPECT_EQ(read.diagnostics.errors()[0].hint,
            "Part the numbers by blanks; the rows before it have the widths (2F8,5F4).");
  EXPECT_EQ(read.diagnostics.errors()[0].line_text, "0.050001.990000.000.000.000.000.00");
}

}  // namespace
}  // namespace tether::test
