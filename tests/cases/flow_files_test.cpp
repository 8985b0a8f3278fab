// SPDX-License-Identifier: GPL-3.0-or-later
// Flows on meshes from files.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <random>

#include "base/diagnostics.hpp"
#include "cases/gmsh_writer.hpp"
#include "cases/run_deck.hpp"
#include "deck/reader.hpp"
#include "grid/block_mesh.hpp"
#include "model/flow.hpp"
#include "model/scene.hpp"
#include "model/solids.hpp"
#include "plan/load.hpp"
#include "unit/temporary_folder.hpp"

namespace tether::cases {
namespace {

/// Off DFG 2D-1 by these parts; G. Nabh's values.
std::array<double, 3> cylinder_errors(const DeckRun& run) {
  return {std::abs(run.summary.at("drag_1") / 5.57953523384 - 1),
          std::abs(run.summary.at("lift_1") / .010618948146 - 1),
          std::abs(run.last("pressure_difference_1") / .11752016697 - 1)};
}

/// Quadrangles in no order, finer near the cylinder, are as good as the blocks of cylinder.in, which follow the wall.
TEST(FlowFiles, CylinderIsAsGoodAsOnBlocks) {
  const DeckRun blocks = run_deck("cylinder"), file = run_deck("cylinder-file");
  EXPECT_LE(file.summary.at("unknowns"), blocks.summary.at("unknowns"));
  const auto of_blocks = cylinder_errors(blocks), of_file = cylinder_errors(file);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_LE(of_file[k], of_blocks[k]) << k;
  EXPECT_LT(of_file[0], 1e-4);
  EXPECT_LT(of_file[1], 4e-3);
  EXPECT_LT(of_file[2], 3e-4);
}

using FlowFilesIn = test::TemporaryFolder;

/// The scene of a deck's text.
Scene scene_of(const std::string& text) {
  Diagnostics diagnostics;
  return load_scene(read_deck(text, "a.in", {}, diagnostics), {{}, "", ""}, diagnostics).plan.scene;
}

void write(const std::filesystem::path& path, const std::string& text) { std::ofstream(path) << text; }

constexpr const char* clock =
    "a deck\n$in nx=2,ny=2,xleft=-9.,xright=9.,ybot=-9.,ytop=9.,wl=1,wr=1,wb=1,wt=1,"
    "tmax=.4,tstep=.05,gravc=-1.,iout(33)=1,tiout(33)=.1,iout(13)=1,tiout(13)=.4 $\n";

/// A channel with a square hole, of eight blocks, and a plate on its bottom wall that is region 9.
std::string blocks_with_a_hole(bool with_plate) {
  constexpr std::array<double, 4> x{0, 1, 1.4, 3}, y{0, .4, .7, 1};
  std::string text = fmt::format("$reg nreg={},densir=9*2.,\n", with_plate ? 9 : 8), mesh = "$mesh element='q2',\n";
  int r = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (i == 1 && j == 1) continue;
      ++r;
      text += fmt::format("nvi({0})=4,xvi(1,{0})={1},{2},{2},{1},yvi(1,{0})={3},{3},{4},{4},matr(1,{0})=.1,\n", r, x[i],
                          x[i + 1], y[j], y[j + 1]);
      mesh += fmt::format("cells(1,{})={},{},\n", r, i == 2 ? 8 : 4, 3);
      if (i == 0) mesh += fmt::format("side(4,{})='in',\n", r);
      if (i == 2) mesh += fmt::format("side(2,{})='out',\n", r);
      if (j == 2) mesh += fmt::format("side(3,{})='top',\n", r);
      const std::array<bool, 4> hole{i == 1 && j == 2, i == 0 && j == 1, i == 1 && j == 0, i == 2 && j == 1};
      for (std::size_t k = 0; k < 4; ++k) {
        if (hole[k]) mesh += fmt::format("side({},{})='hole',\n", k + 1, r);
      }
    }
  }
  if (with_plate) {
    text += "nvi(9)=4,xvi(1,9)=2.,2.2,2.2,2.,yvi(1,9)=0.,0.,.5,.5,matr(1,9)=500.,.3";
    mesh += "cells(1,9)=1,2,side(1,9)='foot'";
  }
  return text + " $\n" + mesh + " $\n";
}

std::string flow_of(const char* element, int fluids, bool with_plate) {
  return fmt::format("$fem law(1)={}*'fluid'{} $\n", fluids, with_plate ? ",'svk',fix_on='foot',fix(1,1)=0.,0." : "") +
         fmt::format(
             "$flow element='{}',tolerance=1e-10,boundary_on(1)='in',boundary(1)='inflow',"
             "boundary_u(1)='y*(1-y)*t',boundary_on(2)='out',boundary(2)='open',force_on='hole',"
             "force_x=1.2,probe(1,1)=.5,.52,1.2,.81,difference(1,1)=1,2,tracers=9,4 $\n",
             element) +
         (with_plate ? "$points tracked_at(1,1)=2.,.5 $\n" : "");
}

void expect_same(const DeckRun& a, const DeckRun& b, bool with_plate) {
  std::vector<std::string> columns{"side_force_x_1",        "side_force_y_1", "side_torque_z_1", "energy_kinetic",
                                   "pressure_difference_1", "probe_vx_1",     "probe_vy_2",      "energy_open"};
  if (with_plate) columns.insert(columns.end(), {"point_x_1", "point_y_1", "energy_strain"});
  for (const std::string& column : columns) {
    ASSERT_NE(a.last(column), 0) << column;
    EXPECT_NEAR(b.last(column) / a.last(column), 1, 1e-7) << column;
  }
  EXPECT_NEAR(b.last("stream_max") - b.last("stream_min"), a.last("stream_max") - a.last("stream_min"), 1e-8);
  for (const char* name : {"x", "y", "left"}) {
    const auto x = read_variable(a.folder + "/particles.nc", name), y = read_variable(b.folder + "/particles.nc", name);
    ASSERT_EQ(x.size(), y.size());
    for (std::size_t k = 0; k < x.size(); ++k) EXPECT_NEAR(x[k], y[k], 1e-8) << name << k;
  }
}

/// A deck on a mesh file whose fluid is region `fluid`, with what $reg and $mesh have of a plate.
std::string deck_on_file(const char* element, const char* file, int fluid, const std::string& reg,
                         const std::string& mesh) {
  const std::string rest = flow_of(element, 1, fluid == 2), flow = rest.substr(rest.find("$flow"));
  const std::string law = fluid == 2 ? "'svk','fluid',fix_on='foot',fix(1,1)=0.,0." : "'fluid'";
  return fmt::format("{}$reg nreg={},densir=2*2.,matr(1,{})=.1,{} $\n$mesh file='{}',{} $\n$fem law(1)={} $\n{}", clock,
                     fluid, fluid, reg, file, mesh, law, flow);
}

/// The same mesh as blocks and from a file, in which everything stands in another order.
TEST_F(FlowFilesIn, AFileGivesWhatTheSameBlocksGive) {
  for (const char* element : {"q1q1", "q2q1"}) {
    const std::string text = clock + blocks_with_a_hole(false) + flow_of(element, 8, false);
    Mesh fluid = scene_of(text).flow()->mesh;
    for (int& region : fluid.region) region = 0;
    write(folder / "fluid.msh", gmsh_text({{fluid, 1}}, 1));
    write(folder / "file.in", deck_on_file(element, "fluid.msh", 1, "", ""));
    expect_same(run_text("blocks", text), run_file((folder / "file.in").string()), false);
  }
}

/// Periodic sides, slip, a body force, and GMRES, whose orderings see other numbers.
TEST_F(FlowFilesIn, AFileGivesThatWithOtherSidesAndByKrylov) {
  for (const char* element : {"q1q1", "q2q1"}) {
    for (const char* solver : {"direct", "krylov"}) {
      const std::string flow = fmt::format(
          "$flow element='{}',solver='{}',tolerance=1e-10,boundary_on(1)='in',boundary(1)='periodic',"
          "boundary_with(1)='out',boundary_on(2)='top',boundary(2)='slip',bx='3',by='x',force_on='hole',force_x=1.2,"
          "probe(1,1)=.5,.52,1.2,.81 $\n",
          element, solver);
      const std::string blocks = clock + blocks_with_a_hole(false);
      const std::string text = blocks + "$fem law=8*'fluid' $\n" + flow;
      Mesh fluid = scene_of(text).flow()->mesh;
      for (int& region : fluid.region) region = 0;
      write(folder / "fluid.msh", gmsh_text({{fluid, 1}}, 21));
      write(folder / "file.in", clock +
                                    std::string("$reg nreg=1,densir=2.,matr(1,1)=.1 $\n$mesh file='fluid.msh' $\n"
                                                "$fem law='fluid' $\n") +
                                    flow);
      const DeckRun a = run_text("blocks", text), b = run_file((folder / "file.in").string());
      for (const char* column : {"side_force_x_1", "side_torque_z_1", "energy_kinetic", "probe_vx_1", "probe_vy_2"})
        EXPECT_NEAR(b.last(column) / a.last(column), 1, 1e-7) << element << solver << column;
    }
  }
}

/// A plate in it, as a block of the deck or from the same file.
/// Of so few elements that all nodes are carried: elements of a file do not stand in rows.
TEST_F(FlowFilesIn, ABodyIsABlockOrOfTheFile) {
  for (const char* element : {"q1q1", "q2q1"}) {
    const std::string kind = std::string(element).substr(0, 2);
    std::string text = clock + blocks_with_a_hole(true) + flow_of(element, 8, true);
    text.replace(text.find("element='q2'"), 12, "element='" + kind + "'");
    const Scene scene = scene_of(text);
    Mesh fluid = scene.flow()->mesh;
    for (int& region : fluid.region) region = 0;
    write(folder / "all.msh", gmsh_text({{fluid, 2}, {scene.solids()->mesh, 1}}, 2));
    write(folder / "fluid.msh", gmsh_text({{fluid, 2}}, 3));
    const DeckRun blocks = run_text("blocks", text);
    write(folder / "all.in", deck_on_file(element, "all.msh", 2, "matr(1,1)=500.,.3", ""));
    expect_same(blocks, run_file((folder / "all.in").string()), true);
    write(folder / "block.in", deck_on_file(element, "fluid.msh", 2,
                                            "matr(1,1)=500.,.3,nvi(1)=4,xvi(1,1)=2.,2.2,2.2,2.,yvi(1,1)=0.,0.,.5,.5",
                                            "cells(1,1)=1,2,side(1,1)='foot',physical(2)='',element='" + kind + "'"));
    expect_same(blocks, run_file((folder / "block.in").string()), true);
  }
}

/// Makes the sides of all elements of order 2 straight.
void straighten(Mesh& mesh) {
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const int* n = mesh.element(e);
    const auto x = [&](int a, std::size_t i) -> double& { return mesh.x[2 * static_cast<std::size_t>(n[a]) + i]; };
    constexpr int middles[5][3] = {{1, 0, 2}, {3, 0, 6}, {5, 2, 8}, {7, 6, 8}, {4, 3, 5}};
    for (const auto& [to, from, other] : middles) {
      for (const std::size_t i : {0u, 1u}) x(to, i) = 0.5 * (x(from, i) + x(other, i));
    }
  }
}

/// The torque of a wall that turns about another, 4 pi mu W a^2 b^2/(b^2 - a^2) for radii a, b: of order 4 by elements
/// whose sides are as curved as the file has them, of order 2 by straight ones.
double torque_error(const std::filesystem::path& folder, const char* element, int around, bool straight) {
  using std::numbers::pi;
  constexpr double a = 1, b = 2, speed = 3;
  const ElementKind kind = element == std::string("q1q1") ? ElementKind::quad4 : ElementKind::quad9;
  std::vector<Block> blocks;
  for (int k = 0; k < 4; ++k) {
    const auto at = [&](double r, int n) {
      const double angle = 0.3 + 0.5 * pi * n;
      return std::array{r * std::cos(angle), r * std::sin(angle)};
    };
    Block block;
    block.edges = {tether::straight(at(a, k), at(b, k)), elliptic(at(b, k), at(b, k + 1), {0, 0}, b, b),
                   tether::straight(at(b, k + 1), at(a, k + 1)), elliptic(at(a, k + 1), at(a, k), {0, 0}, a, a)};
    block.cells = {around / 4, around / 4, 1}, block.names = {"", "rim", "", "axle", "", ""};
    blocks.push_back(block);
  }
  std::vector<MeshFlaw> flaws;
  Mesh mesh = mesh_of_blocks(blocks, kind, flaws);
  for (int& region : mesh.region) region = 0;
  if (straight) straighten(mesh);
  write(folder / "ring.msh", gmsh_text({{mesh, 1}}, 5));
  write(folder / "ring.in",
        fmt::format(
            "a ring\n$in nx=2,ny=2,xleft=-9.,xright=9.,ybot=-9.,ytop=9.,tmax=1.,tstep=1.,iout(33)=1,tiout(33)=1. $\n"
            "$reg nreg=1,densir=1.,matr(1,1)=.7 $\n$mesh file='ring.msh' $\n$fem law(1)='fluid' $\n"
            "$flow element='{}',steady=.true.,tolerance=1e-10,boundary_on(1)='axle',boundary(1)='moving',"
            "boundary_u(1)='-3*y',boundary_v(1)='3*x',force_on='axle' $\n",
            element));
  const DeckRun run = run_file((folder / "ring.in").string());
  const double exact = -4 * pi * 0.7 * speed * a * a * b * b / (b * b - a * a);
  return std::abs(run.last("side_torque_z_1") / exact - 1);
}

TEST_F(FlowFilesIn, CurvedSidesAreCurved) {
  const auto order = [&](const char* element, bool straight) {
    const double coarse = torque_error(folder, element, 16, straight),
                 fine = torque_error(folder, element, 32, straight);
    return std::pair(std::log2(coarse / fine), fine);
  };
  const auto [curved, of_curved] = order("q2q1", false);
  EXPECT_GT(curved, 3.7);
  EXPECT_LT(of_curved, 1e-4);
  const auto [bent, of_straight] = order("q2q1", true);
  EXPECT_NEAR(bent, 2, 0.3);
  EXPECT_GT(of_straight, 30 * of_curved);
  EXPECT_NEAR(order("q1q1", false).first, 2, 0.5);
}

/// Poiseuille's flow is in the space of q2q1 on any straight-sided quadrangles: exact on distorted ones, though each is
/// moved by up to a third of its size.
TEST_F(FlowFilesIn, DistortedQuadranglesHaveAParabola) {
  Block block;
  block.edges = {straight({0, 0}, {3, 0}), straight({3, 0}, {3, 1}), straight({3, 1}, {0, 1}),
                 straight({0, 1}, {0, 0})};
  block.cells = {9, 5, 1}, block.names = {"", "out", "", "in", "", ""};
  std::vector<MeshFlaw> flaws;
  Mesh mesh = mesh_of_blocks({block}, ElementKind::quad9, flaws);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(-0.33, 0.33);
  std::vector<char> seen(mesh.node_count(), 0);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (const int a : {0, 2, 6, 8}) {
      const auto n = static_cast<std::size_t>(mesh.element(e)[a]);
      double *x = &mesh.x[2 * n], dx = part(random) / 3, dy = part(random) / 5;
      if (seen[n]++ || x[0] < 1e-9 || x[0] > 3 - 1e-9 || x[1] < 1e-9 || x[1] > 1 - 1e-9) continue;
      x[0] += dx, x[1] += dy;
    }
  }
  straighten(mesh);
  write(folder / "channel.msh", gmsh_text({{mesh, 1}}, 11));
  write(folder / "channel.in",
        "a channel\n$in nx=2,ny=2,xleft=-9.,xright=9.,ybot=-9.,ytop=9.,tmax=1.,tstep=1.,iout(33)=1,tiout(33)=1. $\n"
        "$reg nreg=1,densir=1.,matr(1,1)=.1 $\n$mesh file='channel.msh' $\n$fem law(1)='fluid' $\n"
        "$flow steady=.true.,tolerance=1e-12,boundary_on(1)='in',boundary(1)='inflow',boundary_u(1)='y*(1-y)',"
        "boundary_on(2)='out',boundary(2)='open',probe(1,1)=.7,.3,2.1,.77,difference(1,1)=1,2 $\n");
  const DeckRun run = run_file((folder / "channel.in").string());
  EXPECT_NEAR(run.last("probe_vx_1"), .3 * .7, 1e-9);
  EXPECT_NEAR(run.last("probe_vx_2"), .77 * .23, 1e-9);
  EXPECT_NEAR(run.last("probe_vy_1"), 0, 1e-9);
  EXPECT_NEAR(run.last("pressure_difference_1"), 2 * .1 * 1.4, 1e-8);
}

}  // namespace
}  // namespace tether::cases
