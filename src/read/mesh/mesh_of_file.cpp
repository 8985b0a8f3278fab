// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/mesh/mesh_of_file.hpp"

#include <fmt/format.h>
#include <algorithm>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "grid/gmsh/file.hpp"
#include "model/flow.hpp"
#include "read/values.hpp"

namespace tether {

Deck load_mesh(const Deck& deck, Diagnostics& diagnostics) {
  const std::string name = deck.text("mesh.file");
  if (name.empty()) return deck;
  const auto error = [&](AnyVariable variable, const std::string& message, const std::string& hint) {
    diagnostics.add(deck.remark(Severity::error, variable, {1, 1}, message, hint));
    return deck;
  };
  if (const std::string mistake = path_mistake(name); !mistake.empty())
    return error("mesh.file", "the mesh path " + mistake, path_hint("../meshes/x.msh"));
  try {
    Deck whole = deck.with_mesh_text(read_file(path_beside(deck, name)));
    const std::string meant = deck.text("mesh.file_sha256");
    if (meant.empty() || meant == sha256(*whole.mesh_text())) return whole;
    return error(
        "mesh.file_sha256",
        fmt::format("'{}' is not the mesh file that was meant: its SHA-256 is {}", name, sha256(*whole.mesh_text())),
        "It was changed. Leave file_sha256 away to take it as it is.");
  } catch (const FileError& reason) {
    return error("mesh.file", fmt::format("mesh file: {}", reason.what()), "the path counts from the deck's folder");
  }
}

namespace {

constexpr const char* vertices_make_blocks =
    "a region with vertices (xvi, yvi) is a block, one without is a group of the file";

bool has_vertices(const Deck& deck, int r) {
  for (const AnyVariable name : Variables{"reg.xvi", "reg.yvi"}) {
    const auto given = deck.given_elements(name);
    if (std::any_of(given.begin(), given.end(), [&](const Subscript& at) { return at[1] == r; })) return true;
  }
  return false;
}

/// Warns of what the deck says of blocks about regions of the file; deck.effective, which shows defaults, too, means
/// nothing by them.
void warn_of_blocks(const Deck& deck, Diagnostics& diagnostics) {
  if (deck.given("mesh.file_sha256")) return;
  const auto warn = [&](AnyVariable name, const std::string& message) {
    const bool of_region = name.row().rank > 0, by_second = name.row().rank == 2;
    const auto given = deck.given_elements(name);
    const auto first = std::find_if(given.begin(), given.end(), [&](const Subscript& at) {
      return !of_region || is_of_file(deck, by_second ? at[1] : at[0]);
    });
    if (first == given.end()) return false;
    diagnostics.add(deck.remark(Severity::warning, name, *first, message));
    return true;
  };
  const std::vector<int> bodies = regions_of(deck, false);
  for (const AnyVariable name : Variables{"mesh.element", "mesh.cells", "mesh.grading", "mesh.grading_middle", "mesh.z",
                                          "mesh.edge", "mesh.side"}) {
    const bool of_bodies = name == "mesh.element";
    if (of_bodies && (bodies.empty() || !is_of_file(deck, bodies.front()))) continue;
    warn(name, fmt::format("{} has no effect: the mesh is that of the file", name));
  }
  for (const AnyVariable name : Variables{"reg.nvi", "reg.xvi", "reg.yvi"}) {
    if (warn(name, fmt::format("{} of $reg has no effect: the mesh is that of the file", name))) break;
  }
}

/// Returns whether the fluid's elements are those of $flow; reports what is taken where they are not.
bool check_fluid(const Deck& deck, ElementKind kind, Diagnostics& diagnostics) {
  const auto refuse = [&](AnyVariable name, const std::string& message, const std::string& hint) {
    diagnostics.add(deck.remark(Severity::error, name, {1, 1}, message, hint));
    return false;
  };
  if (dimension_of(kind) == 3)
    return refuse("mesh.file", "a fluid is plane, and the file's elements are those of a body in space",
                  "save a mesh of quadrangles: gmsh -2");
  if (is_simplex(kind))
    return refuse(
        "mesh.file", "a fluid takes quadrangles, and the file's elements are triangles",
        "'Recombine Surface{:};' and 'Mesh.SubdivisionAlgorithm = 1;' in the .geo make quadrangles: of 4 nodes "
        "for element='q1q1' of $flow, of 9 by gmsh -2 -order 2 for 'q2q1'");
  const bool bilinear = word<FlowElement>(deck, "flow.element") == FlowElement::q1q1;
  if (bilinear == (kind == ElementKind::quad4)) return true;
  return refuse("flow.element",
                bilinear ? "element='q1q1' takes 4-node quadrangles, and those of the file have 9 nodes"
                         : "element='q2q1' takes 9-node quadrangles, and those of the file have 4 nodes",
                bilinear ? "save them by gmsh -2 -order 1, or write element='q2q1'"
                         : "save them by gmsh -2 -order 2, or write element='q1q1'");
}

}  // namespace

bool is_of_file(const Deck& deck, int r) {
  return !deck.text("mesh.file").empty() && r <= deck.integer("reg.nreg") && !(has_flow(deck) && has_vertices(deck, r));
}

bool check_sources(const Deck& deck, Diagnostics& diagnostics) {
  if (deck.text("mesh.file").empty()) return true;
  bool good = true, any = false;
  for (const bool fluid : {true, false}) {
    const std::vector<int> regions = regions_of(deck, fluid);
    for (const int r : regions) {
      const bool file = is_of_file(deck, r);
      any |= file;
      if (file == is_of_file(deck, regions.front())) continue;
      diagnostics.add(remark_on_region(
          deck, Severity::error, r,
          fmt::format(
              "region {} is {}, and region {} is {}: {}", r, file ? "a group of the file" : "a block", regions.front(),
              file ? "a block" : "a group of the file",
              fluid ? "a fluid is all of the file or all of blocks" : "bodies are all of the file or all blocks"),
          vertices_make_blocks));
      good = false;
      break;
    }
  }
  if (any) return good;
  diagnostics.add(deck.remark(Severity::error, "mesh.file", {1, 1},
                              "no region is a group of this file: all have vertices", vertices_make_blocks));
  return false;
}

DeckMeshes meshes_of_file(const Deck& deck, Diagnostics& diagnostics) {
  warn_of_blocks(deck, diagnostics);
  DeckMeshes meshes;
  if (!deck.mesh_text()) return meshes;  // why, has been reported
  std::vector<FileRegion> regions;
  std::vector<bool> is_fluid;  // of each mesh
  for (const bool fluid : {true, false}) {
    const std::vector<int> all = regions_of(deck, fluid);
    if (all.empty() || !is_of_file(deck, all.front())) continue;
    for (const int r : all) regions.push_back({r, deck.text("mesh.physical", r), is_fluid.size()});
    is_fluid.push_back(fluid);
  }
  std::vector<MeshFlaw> flaws;
  std::vector<Mesh> found = read_gmsh_meshes(*deck.mesh_text(), path_beside(deck, deck.text("mesh.file")).string(),
                                             regions, flaws, diagnostics);
  for (const MeshFlaw& flaw : flaws) {
    const int r = regions[flaw.region].number;
    diagnostics.add(
        remark_on_region(deck, Severity::error, r, fmt::format("region {}: {}", r, flaw.message),
                         "region r is the physical group of tag r, or the one that physical(r) of $mesh names"));
  }
  for (std::size_t m = 0; m < found.size(); ++m) {
    if (is_fluid[m] && !check_fluid(deck, found[m].kind, diagnostics)) continue;
    (is_fluid[m] ? meshes.fluid : meshes.bodies) = std::move(found[m]);
  }
  return meshes;
}

Diagnostic remark_on_region(const Deck& deck, Severity severity, int r, const std::string& message,
                            const std::string& hint) {
  const bool named = deck.given("mesh.physical", r), file = is_of_file(deck, r);
  if (!file) return deck.remark(severity, "reg.xvi", {1, r}, message, hint);
  return deck.remark(severity, named ? AnyVariable("mesh.physical") : "reg.nreg", {named ? r : 1, 1}, message, hint);
}

}  // namespace tether
