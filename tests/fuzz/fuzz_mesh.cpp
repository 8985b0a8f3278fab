// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a mesh file.
#include <cmath>
#include <cstdint>
#include <string_view>

#include "base/text.hpp"
#include "fuzz/properties.hpp"
#include "grid/gmsh/file.hpp"

namespace tether::fuzz {
namespace {

void expect_consistent(const Mesh& mesh) {
  expect(mesh.element_count() > 0, "a mesh has elements");
  expect(mesh.nodes.size() == mesh.element_count() * static_cast<std::size_t>(node_count_of(mesh.kind)),
         "each element has its nodes");
  for (const int node : mesh.nodes)
    expect(node >= 0 && static_cast<std::size_t>(node) < mesh.node_count(), "an element's node is there");
  for (const double x : mesh.x) expect(std::isfinite(x), "a place is a number");
  expect(inverted_elements(mesh).empty() && !hanging_node(mesh) && coinciding_nodes(mesh).empty(), "a mesh is sound");
  for (const auto& [name, nodes] : mesh.sides) {
    expect(!nodes.empty() && nodes.size() % static_cast<std::size_t>(side_node_count_of(mesh.kind)) == 0,
           "a side is made of whole sides: " + name);
  }
}

}  // namespace
}  // namespace tether::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  tether::Diagnostics diagnostics;
  std::vector<tether::MeshFlaw> flaws;
  const auto mesh = tether::read_gmsh(text, "a.msh", {""}, flaws, diagnostics);
  tether::fuzz::expect_places_inside(diagnostics, tether::split_lines(text));
  const bool told = diagnostics.has_errors() || !flaws.empty();
  tether::fuzz::expect(mesh.has_value() != told, "there is a mesh or a mistake");
  if (mesh) tether::fuzz::expect_consistent(*mesh);
  return 0;
}
