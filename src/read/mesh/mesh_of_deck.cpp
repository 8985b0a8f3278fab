// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "base/vec.hpp"
#include "deck/words.hpp"
#include "grid/block_mesh.hpp"
#include "model/flow.hpp"
#include "read/mesh/mesh_of_deck.hpp"
#include "read/mesh/mesh_of_file.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

/// One region as a block; reports what is wrong with it.
class BlockReader {
 public:
  BlockReader(const Deck& deck, int r, bool solid, Diagnostics& diagnostics)
      : deck_(deck), r_(r), solid_(solid), diagnostics_(diagnostics) {}

  std::optional<Block> read() {
    if (deck_.integer("reg.nvi", r_) != 4) {
      error("reg.nvi", {r_, 1}, fmt::format("a block of a mesh has 4 vertices, not {}", deck_.integer("reg.nvi", r_)),
            "give nvi, xvi and yvi of its corners, counter-clockwise");
      return std::nullopt;
    }
    std::array<Vec<2>, 4> corners;
    for (int k = 1; k <= 4; ++k) {
      if (!deck_.given("reg.xvi", k, r_) || !deck_.given("reg.yvi", k, r_)) {
        error("reg.nvi", {r_, 1}, fmt::format("vertex {} is not given", k), "nvi vertices need an x and a y each");
        return std::nullopt;
      }
      corners[static_cast<std::size_t>(k - 1)] = {deck_.real("reg.xvi", k, r_), deck_.real("reg.yvi", k, r_)};
    }
    Block block;
    for (int k = 1; k <= 4; ++k) {
      const auto edge = static_cast<std::size_t>(k - 1);
      block.edges[edge] = curve(k, corners[edge], corners[(edge + 1) % 4]);
    }
    for (int k = 1; k <= 3; ++k) {
      block.cells[static_cast<std::size_t>(k - 1)] = deck_.integer("mesh.cells", k, r_);
      block.grading[static_cast<std::size_t>(k - 1)] = deck_.real("mesh.grading", k, r_);
      block.grading_middle[static_cast<std::size_t>(k - 1)] = deck_.real("mesh.grading_middle", k, r_);
    }
    check_gradings(block);
    block.number = r_;
    for (int k = 1; k <= 6; ++k) block.names[static_cast<std::size_t>(k - 1)] = deck_.text("mesh.side", k, r_);
    if (solid_) read_depth(block);
    return block;
  }

 private:
  void error(AnyVariable name, Subscript at, const std::string& message, const std::string& hint) {
    diagnostics_.add(deck_.remark(Severity::error, name, at, fmt::format("region {}: {}", r_, message), hint));
  }
  EdgeCurve curve(int k, Vec<2> from, Vec<2> to) {
    const auto kind = word<MeshEdge>(deck_, "mesh.edge", k, r_);
    if (kind == MeshEdge::line) return straight(from, to);
    const Vec<2> centre{deck_.real("mesh.edge_xc", k, r_), deck_.real("mesh.edge_yc", k, r_)};
    double a = std::hypot(from[0] - centre[0], from[1] - centre[1]), b = a;
    if (kind == MeshEdge::ellipse) {
      if (!deck_.given("mesh.edge_a", k, r_) || !deck_.given("mesh.edge_b", k, r_)) {
        error("mesh.edge", {k, r_}, fmt::format("edge {} is an ellipse without half axes", k),
              "give edge_a and edge_b");
        return straight(from, to);
      }
      a = deck_.real("mesh.edge_a", k, r_), b = deck_.real("mesh.edge_b", k, r_);
    }
    for (const Vec<2>& end : {from, to}) {
      const double off = std::hypot((end[0] - centre[0]) / a, (end[1] - centre[1]) / b) - 1;
      if (std::abs(off) < 1e-3) continue;
      error("mesh.edge", {k, r_},
            fmt::format("edge {} does not go through ({:.6g}, {:.6g}): it passes {:.2g} of its radius beside it", k,
                        end[0], end[1], std::abs(off)),
            "both vertices lie on the curve");
      return straight(from, to);
    }
    return elliptic(from, to, centre, a, b);
  }
  void check_gradings(const Block& block) {
    for (int k = 1; k <= 3; ++k) {
      const auto axis = static_cast<std::size_t>(k - 1);
      if (block.grading[axis] == 1 || block.grading_middle[axis] == 1) continue;
      error("mesh.grading_middle", {k, r_},
            fmt::format("grading({0},{1}) and grading_middle({0},{1}) are both given", k, r_),
            "cells grow from the first to the last, or from both ends to the middle: leave one away");
    }
  }
  void read_depth(Block& block) {
    for (const int k : {1, 2}) {
      if (deck_.given("mesh.z", k, r_)) continue;
      const Subscript other = deck_.given_elements("mesh.z").front();
      error("mesh.z", other, fmt::format("z({},{}) is not given, but z({},{}) is", k, r_, other[0], other[1]),
            "all regions have a lowest and a highest z, or none has");
      return;
    }
    block.z_low = deck_.real("mesh.z", 1, r_), block.z_high = deck_.real("mesh.z", 2, r_);
    if (block.z_high > block.z_low) return;
    error("mesh.z", {2, r_}, fmt::format("z = {:.6g} is not above {:.6g}", block.z_high, block.z_low),
          "the lowest first");
  }

  const Deck& deck_;
  int r_;
  bool solid_;
  Diagnostics& diagnostics_;
};

/// Bodies are of q2 unless the deck says otherwise: where they bend, and where they hardly change their volume, no
/// other element is as exact for the same seconds.
ElementKind kind_of(const Deck& deck, bool fluid, bool solid) {
  if (fluid)
    return word<FlowElement>(deck, "flow.element") == FlowElement::q1q1 ? ElementKind::quad4 : ElementKind::quad9;
  return element_kind(deck.text("mesh.element"), solid ? 3 : 2);
}

std::optional<Mesh> mesh_of_deck_blocks(const Deck& deck, const std::vector<int>& regions, bool fluid,
                                        Diagnostics& diagnostics) {
  const bool solid = !fluid && !deck.given_elements("mesh.z").empty();
  std::vector<Block> blocks;
  for (const int r : regions) {
    if (auto block = BlockReader(deck, r, solid, diagnostics).read()) blocks.push_back(std::move(*block));
  }
  if (diagnostics.has_errors()) return std::nullopt;
  std::vector<MeshFlaw> flaws;
  Mesh mesh = mesh_of_blocks(blocks, kind_of(deck, fluid, solid), flaws);
  for (const MeshFlaw& flaw : flaws) {
    const int r = number_of(blocks, flaw.region);
    diagnostics.add(
        deck.remark(Severity::error, "reg.xvi", {1, r}, fmt::format("region {}: {}", r, flaw.message), flaw.hint));
  }
  return flaws.empty() ? std::optional(std::move(mesh)) : std::nullopt;
}

}  // namespace

DeckMeshes meshes_of(const Deck& deck, Diagnostics& diagnostics) {
  DeckMeshes meshes;
  if (regions_of(deck).empty()) {
    diagnostics.add(deck.remark(Severity::error, "reg.nreg", {1, 1}, "a mesh needs a region at least",
                                "nreg counts the blocks that the mesh is made of, or the physical groups of its file"));
    return meshes;
  }
  if (!deck.text("mesh.file").empty()) meshes = meshes_of_file(deck, diagnostics);
  for (const bool fluid : {true, false}) {
    const std::vector<int> regions = regions_of(deck, fluid);
    if (regions.empty() || is_of_file(deck, regions.front())) continue;
    (fluid ? meshes.fluid : meshes.bodies) = mesh_of_deck_blocks(deck, regions, fluid, diagnostics);
  }
  return meshes;
}

}  // namespace tether
