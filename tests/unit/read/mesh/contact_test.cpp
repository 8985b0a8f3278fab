// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "deck/document.hpp"
#include "model/solids.hpp"
#include "read/path.hpp"
#include "unit/read/scene_support.hpp"

namespace tether::test {
namespace {

/// Two squares of one element of order 1 each, in the box 0 .. 1 by 0 .. 1; `contact` is line 11, `fem` line 8.
std::string squares(const std::string& contact, const std::string& fem = "", const std::string& mesh = "") {
  return on_unit_square(
      "$\n$reg nreg=2,nvi=4,4,xvi(1,1)=.1,.4,.4,.1,xvi(1,2)=.6,.9,.9,.6,densir=2*1.,\n"
      "yvi(1,1)=.2,.2,.8,.8,yvi(1,2)=.2,.2,.8,.8,matr(1,1)=9.,.3,matr(1,2)=9.,.3 $\n$mesh element='q1'," +
      mesh + "$\n$fem law(1)='neo-hookean','neo-hookean'\n" + fem + "\n$\n$contact\n" + contact + "\n$\n");
}

/// The same in space, from z = 0 to 1.
std::string cubes(const std::string& contact) { return squares(contact, "", "z(1,1)=0.,1.,z(1,2)=0.,1. "); }

Contact contact_of(const Built& built) {
  EXPECT_EQ(built.errors(), Texts{});
  EXPECT_EQ(built.diagnostics.warnings().size(), 0u);
  const Solids* solids = built.scene.solids();
  return solids && solids->contact ? *solids->contact : Contact{};
}

TEST(ContactGroup, TurnsContactOnByBeingThere) {
  const Built built = build_on_mesh(squares(""));
  const Contact contact = contact_of(built);
  ASSERT_TRUE(built.scene.solids()->contact.has_value());
  EXPECT_TRUE(contact.bodies && contact.itself && contact.nodes.empty() && contact.planes.empty());
  EXPECT_TRUE(contact.obstacles.empty());
  for (const double number : {contact.stiffness, contact.friction, contact.stick}) EXPECT_EQ(number, 0);
  EXPECT_NEAR(contact.gap, 0.03, 1e-15);  // a tenth of the shortest side
  EXPECT_EQ(contact.step, ContactStep::automatic);
  EXPECT_FALSE(is_damped(contact));

  std::string without = squares("");
  without.erase(without.find("$contact"));
  EXPECT_FALSE(build_on_mesh(without).scene.solids()->contact.has_value());
}

TEST(ContactGroup, GivesEverything) {
  const Contact contact = contact_of(
      build_on_mesh(squares("on(1)='2.left',on(2)='1.right',gap=.02,stiffness=3.,friction=.4,stick=.5,step='energy',"
                            "bodies=.false.,itself=.false.,wall(1)='right',wall(2)='bottom',plane(1,2)=.5,.9,0.,-2.,"
                            "obstacle(1,3)=.1,.4,.85,.95")));
  EXPECT_EQ(contact.gap, 0.02);
  EXPECT_EQ(contact.stiffness, 3);
  EXPECT_EQ(contact.friction, 0.4);
  EXPECT_EQ(contact.stick, 0.5);
  EXPECT_EQ(contact.step, ContactStep::energy);
  EXPECT_FALSE(contact.bodies || contact.itself || is_damped(contact));
  EXPECT_EQ(contact.nodes.size(), 4u);
  EXPECT_TRUE(std::is_sorted(contact.nodes.begin(), contact.nodes.end()));
  ASSERT_EQ(contact.planes.size(), 3u);
  EXPECT_EQ(contact.planes[0].place[0], 1);
  EXPECT_EQ(contact.planes[0].normal, (Vec<3>{-1, 0, 0}));
  EXPECT_EQ(contact.planes[1].place[1], 0);
  EXPECT_EQ(contact.planes[1].normal, (Vec<3>{0, 1, 0}));
  EXPECT_EQ(contact.planes[2].place, (Vec<3>{0.5, 0.9, 0}));
  EXPECT_EQ(contact.planes[2].normal, (Vec<3>{0, -1, 0}));
  ASSERT_EQ(contact.obstacles.size(), 1u);
  EXPECT_EQ(contact.obstacles[0].low, (Vec<3>{0.1, 0.85, 0}));
  EXPECT_EQ(contact.obstacles[0].high, (Vec<3>{0.4, 0.95, 0}));
}

TEST(ContactGroup, HasNodesOfASideAndOfItsRegionOnce) {
  const Built built = build_on_mesh(squares("on(1)='region 1',on(2)='1.right'"));
  const Contact contact = contact_of(built);
  ASSERT_EQ(contact.nodes.size(), 4u);
  const Mesh& mesh = built.scene.solids()->mesh;
  for (const int node : contact.nodes) EXPECT_LT(mesh.x[2 * static_cast<std::size_t>(node)], 0.5);
}

TEST(ContactGroup, HasPlanesAndObstaclesInSpace) {
  const Contact contact =
      contact_of(build_on_mesh(cubes("plane(1,1)=0.,0.,-1.,3.,0.,4.,obstacle(1,1)=0.,1.,0.,1.,2.,3.")));
  ASSERT_EQ(contact.planes.size(), 1u);
  EXPECT_EQ(contact.planes[0].place, (Vec<3>{0, 0, -1}));
  EXPECT_NEAR(contact.planes[0].normal[0], 0.6, 1e-15);
  EXPECT_NEAR(contact.planes[0].normal[2], 0.8, 1e-15);
  ASSERT_EQ(contact.obstacles.size(), 1u);
  EXPECT_EQ(contact.obstacles[0].low, (Vec<3>{0, 0, 2}));
  EXPECT_EQ(contact.obstacles[0].high, (Vec<3>{1, 1, 3}));
  EXPECT_EQ(build_on_mesh(cubes("plane(1,1)=0.,0.,0.,1.")).errors(),
            (Texts{"11:12: plane 1: plane(5,1) is not given"}));
}

/// No barrier can stand between a body and a plane or an obstacle that it touches; between those that are near to each
/// other one begins where they are, but for equilibria, which it has to hold.
TEST(ContactGroup, TakesItsGapFromTheStart) {
  for (const char* touching : {"plane(1,1)=0.,.2,0.,1.", "obstacle(1,1)=0.,1.,.8,.9"}) {
    const Texts errors = build_on_mesh(squares(touching)).errors();
    ASSERT_EQ(errors.size(), 1u) << touching;
    EXPECT_NE(errors[0].find("touch at the start"), std::string::npos) << errors[0];
  }
  const char* near = "plane(1,1)=0.,.19,0.,1.";
  EXPECT_NEAR(contact_of(build_on_mesh(squares(near))).gap, 0.01, 1e-12);
  EXPECT_NEAR(contact_of(build_on_mesh(squares(near, "static=.true."))).gap, 0.03, 1e-12);
  EXPECT_EQ(build_on_mesh(squares("gap=.02,plane(1,1)=0.,.19,0.,1.")).diagnostics.warnings().size(), 1u);
}

/// What contact may hold needs no supports.
TEST(ContactGroup, EquilibriaMayHaveFreeBodies) {
  for (const char* rests : {"static=.true.", "settle=.true."}) {
    EXPECT_EQ(build_on_mesh(squares("wall(1)='bottom'", rests)).errors(), Texts{}) << rests;
    std::string without = squares("", rests);
    without.erase(without.find("$contact"));
    EXPECT_EQ(build_on_mesh(without).errors().size(), 1u) << rests;
  }
}

Texts warnings_of(const std::string& deck) {
  Texts texts;
  for (const auto& d : build_on_mesh(deck).diagnostics.warnings()) texts.push_back(d.message);
  return texts;
}

TEST(ContactGroup, WarnsOfWhatHasNoEffect) {
  EXPECT_EQ(warnings_of(squares("stick=.1")), (Texts{"stick of $contact has no effect: there is no friction"}));
  std::string deck = squares("wall(1)='bottom'");
  deck.replace(deck.find("ybot=0."), 7, "ybot=.2");
  EXPECT_EQ(warnings_of(deck), (Texts{"wb of $in holds 4 nodes that start at the bottom: they never leave it"}));
  deck.replace(deck.find("law(1)='neo-hookean'"), 20, "law(1)='svk'");
  EXPECT_EQ(warnings_of(deck).size(), 2u);
}

/// Bodies that overlap are a mistake where contact stops them at one another, and else doubtful.
TEST(ContactGroup, BodiesDoNotStartInOneAnother) {
  std::string deck = squares("");
  deck.replace(deck.find(".6,.9,.9,.6"), 11, ".3,.9,.9,.3");
  deck.replace(deck.find("yvi(1,2)=.2,.2,.8,.8"), 20, "yvi(1,2)=.3,.3,.9,.9");
  const Texts errors = build_on_mesh(deck).errors();
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_NE(errors[0].find("overlap at the start: node"), std::string::npos);
  EXPECT_TRUE(errors[0].ends_with("lies inside both, 0.1 from the nearest side of the latter")) << errors[0];
  deck.replace(deck.find("$contact\n"), 9, "$contact\nbodies=.false.");
  EXPECT_EQ(build_on_mesh(deck).errors(), Texts{});
  EXPECT_EQ(warnings_of(deck).size(), 1u);
}

/// A deck without the group stays one as it is written down, and other paths leave the group out.
TEST(ContactGroup, IsWrittenWhereItIsThereAlone) {
  Diagnostics diagnostics;
  const auto read = [&](const std::string& text) { return read_deck(text, "a.in", {}, diagnostics); };
  EXPECT_EQ(effective_deck(read(square_region())).find("$contact"), std::string::npos);
  const Deck deck = read(squares(""));
  EXPECT_NE(effective_deck(deck).find("$contact"), std::string::npos);
  EXPECT_FALSE(deck_of_path(deck.with_path("mpm"), Path::mpm, diagnostics).has_group("contact"));
  EXPECT_TRUE(deck_of_path(deck.with_path("fem"), Path::fem, diagnostics).has_group("contact"));
}

}  // namespace
}  // namespace tether::test
