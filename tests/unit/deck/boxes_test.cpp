// SPDX-License-Identifier: GPL-3.0-or-later
// The twelve decks of the thesis, exactly as printed. How many values each gives was counted with gfortran's namelist
// reader on decks repaired for it (terminators, the slips of Boxes 2 and 9); all values agreed bit by bit.
#include <gtest/gtest.h>

#include "deck_support.hpp"

namespace tether::test {
namespace {

struct Box {
  const char* name;
  std::size_t values;
  Texts warnings;
};

void PrintTo(const Box& box, std::ostream* out) { *out << box.name; }

constexpr const char* no_nregrig = ": $regrig is there without nregrig";
constexpr const char* off = ": tiout is set for outputs that are off (iout = 0): ";

Texts ellipse_slips() {
  return {"34:9: rix(2) is set twice, first at 32:9; the later value holds", "34:21: rex(3) is set but rix(3) never is",
          "35:9: riy(2) is set twice, first at 33:9; the later value holds",
          "35:21: rey(3) is set but riy(3) never is"};
}

std::vector<Box> boxes() {
  const auto at = [](const char* place, const char* what, const char* rest = "") {
    return std::string(place) + what + rest;
  };
  auto box11 = ellipse_slips();
  box11.insert(box11.begin(), {at("11:23", off, "36"), at("18:2", no_nregrig)});
  return {
      {"box01_sod.in", 105, {at("9:22", off, "30, 33, 34, 35, 36, 37, 38"), at("22:1", no_nregrig)}},
      {"box02_gasexp.in",
       60,
       {at("9:22", off, "30, 31, 32"), "13:1: $fluid opens while $in is still open; $in ends here",
        at("17:1", no_nregrig), "22:10: vertex 1 of region 1 is outside the grid"}},
      {"box03_springmass.in", 34, {at("9:22", off, "30, 31"), at("19:1", no_nregrig)}},
      {"box06_pendulum.in", 43, {at("10:22", off, "31, 35, 36, 37, 40"), at("23:1", no_nregrig)}},
      {"box08_ballnet.in", 66, {at("9:23", off, "31, 32, 33, 37, 40"), at("19:2", no_nregrig)}},
      {"box09_membrane.in",
       90,
       {"9:23: the last '.' of '2.00.' is dropped: tiout(32) = 2.00", at("12:23", off, "37"),
        "15:23: the last '.' of '2.0.' is dropped: tiout(41) = 2.0", at("22:2", no_nregrig),
        "26:10: nvi(3) is set but nreg = 2"}},
      {"box10_cyl200.in", 128, ellipse_slips()},
      {"box11_cyl500.in", 129, box11},
      {"box12_piston.in",
       84,
       {at("9:23", off, "30, 31, 32, 34, 35, 36, 37, 38, 39, 40"), "40:10: vrx(2) is set but nreg = 1",
        "41:10: vry(2) is set but nreg = 1"}},
      {"box14_stability.in", 19, {at("13:1", no_nregrig)}},
      {"box15_twobar.in", 101, {at("9:23", off, "30, 31, 32, 35, 36, 37, 40"), at("22:2", no_nregrig)}},
      {"box16_ballnet_orig.in", 66, {at("9:23", off, "31, 32, 33, 37, 40"), at("19:2", no_nregrig)}},
  };
}

class Boxes : public testing::TestWithParam<Box> {};

TEST_P(Boxes, ReadAsPrinted) {
  const auto reading = read(box_text(GetParam().name));
  EXPECT_EQ(reading.errors(), Texts{});
  EXPECT_EQ(reading.warnings(), GetParam().warnings);
  std::size_t values = 0;
  for (const auto& variable : variables()) {
    values += reading.deck.given_elements(AnyVariable(variable)).size();
  }
  EXPECT_EQ(values, GetParam().values);
}

/// What changes a value that was meant, or a part of the deck, stays a warning.
TEST(BoxSlips, ThatDoNoHarmAreRemarks) {
  Texts doubtful;
  for (const auto& name : box_names()) {
    const auto reading = read(box_text(name));
    for (const auto& diagnostic : reading.diagnostics.warnings())
      doubtful.push_back(name.substr(0, 5) + ": " + diagnostic.message.substr(0, 30));
  }
  const Texts ellipses{"rix(2) is set twice, first at ", "rex(3) is set but rix(3) never",
                       "riy(2) is set twice, first at ", "rey(3) is set but riy(3) never"};
  Texts expected{"box02: $fluid opens while $in is stil", "box02: vertex 1 of region 1 is outsid"};
  for (const char* box : {"box10: ", "box11: "}) {
    for (const auto& slip : ellipses) expected.push_back(box + slip);
  }
  EXPECT_EQ(doubtful, expected);
}

INSTANTIATE_TEST_SUITE_P(Thesis, Boxes, testing::ValuesIn(boxes()));

std::vector<double> column(const Deck& deck, RealVariable name, int region, int count) {
  std::vector<double> values;
  for (int k = 1; k <= count; ++k) values.push_back(deck.real(name, k, region));
  return values;
}

using Reals = std::vector<double>;

TEST(BoxValues, Sod) {
  const auto deck = read(box_text("box01_sod.in")).deck;
  EXPECT_EQ(deck.header(), (Texts{"'\"ary'\"", "\"sods problem\" '"}));
  EXPECT_EQ(deck.integer("in.nx"), 101);
  EXPECT_EQ(deck.real("in.tstep"), 1e-4);
  EXPECT_EQ(deck.real("in.tiout", 37), 0.25);
  EXPECT_EQ(deck.integer("in.iout", 39), 1);
  EXPECT_FALSE(deck.logical("in.large"));
  EXPECT_EQ(deck.real("fluid.siep", 2), 2.0);
  EXPECT_EQ(column(deck, "reg.xvi", 2, 4), (Reals{0.5, 1, 1, 0.5}));
  EXPECT_EQ(column(deck, "reg.matr", 2, 7), (Reals{1e5, 0, 1e26, 2e25, 1e20, 100, 0}));
  EXPECT_EQ(deck.integer("reg.ipath", 4, 2), 9);
  EXPECT_EQ(deck.real("reg.densir", 2), 0.125);
  EXPECT_FALSE(deck.given("reg.xcenter", 2));
  EXPECT_EQ(deck.place("reg.densir", 2).line, 37);
  EXPECT_EQ(deck.place("reg.densir", 2).column, 26);
}

TEST(BoxValues, GasExpansionGoesOnInFluid) {
  const auto deck = read(box_text("box02_gasexp.in")).deck;
  EXPECT_EQ(deck.real("in.tiout", 33), 0.02);
  EXPECT_EQ(deck.real("fluid.siep"), 250.0);
  EXPECT_EQ(deck.real("in.tmax"), 0.02);
}

TEST(BoxValues, SpringHasNoCommaBeforeItsLastLines) {
  const auto deck = read(box_text("box03_springmass.in")).deck;
  EXPECT_EQ(deck.real("in.gravc"), -250.0);
  EXPECT_EQ(deck.integer("in.methd"), 0);
  EXPECT_EQ(deck.real("in.tstep"), 0.18e-5);
  EXPECT_EQ(deck.integer("reg.nreg"), 0);
}

TEST(BoxValues, MembraneExpansion) {
  const auto deck = read(box_text("box09_membrane.in")).deck;
  EXPECT_EQ(deck.integer("in.ny"), 33);
  EXPECT_EQ(deck.integer("in.iprint"), 0);
  EXPECT_EQ(deck.real("in.tiout", 32), 2.0);
  EXPECT_EQ(deck.real("in.tiout", 41), 2.0);
  EXPECT_EQ(deck.real("fluid.siep", 2), 250.0);
  EXPECT_EQ(deck.integer("reg.nvi", 5), 4);
  EXPECT_EQ(column(deck, "reg.yvi", 2, 4), (Reals{0.65, 0.65, 0.74, 0.9}));
}

TEST(BoxValues, AirbagOfTenVertices) {
  const auto deck = read(box_text("box10_cyl200.in")).deck;
  EXPECT_EQ(column(deck, "reg.xvi", 1, 10), (Reals{0, 0.14, 0.22, 0.26, 0.28, 0.26, 0.22, 0.18, 0.14, 0}));
  EXPECT_EQ(column(deck, "reg.yvi", 2, 3), (Reals{0.299, 0.318, 0.299}));
  EXPECT_EQ(deck.real("reg.vry", 3), -3.9);
  EXPECT_EQ(deck.real("in.cyl"), 1.0);
  EXPECT_FALSE(deck.given("reg.rix", 3));
  EXPECT_EQ(deck.real("reg.rex", 3), 100.0);
  EXPECT_EQ(deck.integer("regrig.nregrig"), 0);
}

TEST(BoxValues, PistonWithoutRegrig) {
  const auto deck = read(box_text("box12_piston.in")).deck;
  EXPECT_FALSE(deck.has_group("regrig"));
  EXPECT_EQ(deck.integer("regrig.nregrig"), 0);
  EXPECT_EQ(column(deck, "reg.matr", 1, 2), (Reals{1.58e6, 0.3}));
  EXPECT_EQ(deck.header().back(), " '\"Olson-Bathe (1983) spring-piston-fluid'\"");
}

TEST(BoxValues, NotesAndParticleDataBehindADeckAreItsTrailer) {
  for (const char* name : {"box03_notes.txt", "box06_notes.txt", "box12_notes.txt", "box09_membrane.par"}) {
    const auto reading = read(box_text("box14_stability.in") + box_text(name));
    EXPECT_EQ(reading.errors(), Texts{});
    EXPECT_EQ(reading.deck.trailer().text, box_text(name));
    EXPECT_EQ(reading.deck.trailer().first_line, 17);
  }
}

}  // namespace
}  // namespace tether::test
