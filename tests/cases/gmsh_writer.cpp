// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/gmsh_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>

namespace tether::cases {
namespace {

/// Lattice numbers of Gmsh's nodes that go around an element: corners, then the middles of its edges.
std::vector<int> corners_around(ElementKind kind) {
  return kind == ElementKind::quad4 ? std::vector{0, 1, 3, 2} : std::vector{0, 2, 8, 6};
}
std::vector<int> middles_of(ElementKind kind) {
  return kind == ElementKind::quad4 ? std::vector<int>{} : std::vector{1, 5, 7, 3};
}

class Writer {
 public:
  explicit Writer(unsigned seed) : random_(seed) {}

  void add(const PlacedMesh& placed) {
    const Mesh& mesh = placed.mesh;
    const int first = static_cast<int>(places_.size());
    for (std::size_t n = 0; n < mesh.node_count(); ++n)
      places_.push_back(fmt::format("{:.17g} {:.17g} 0", mesh.x[2 * n], mesh.x[2 * n + 1]));
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      std::vector<int> corners = corners_around(mesh.kind), middles = middles_of(mesh.kind);
      const auto turn = static_cast<std::ptrdiff_t>(random_() % 4);
      std::rotate(corners.begin(), corners.begin() + turn, corners.end());
      if (!middles.empty()) std::rotate(middles.begin(), middles.begin() + turn, middles.end());
      corners.insert(corners.end(), middles.begin(), middles.end());
      if (mesh.kind == ElementKind::quad9) corners.push_back(4);
      for (int& a : corners) a = first + mesh.element(e)[a];
      elements_.push_back({mesh.kind == ElementKind::quad4 ? 3 : 10, placed.tag + mesh.region[e], corners});
    }
    for (const auto& [name, sides] : mesh.sides) add_sides(mesh.kind, name, sides, first);
  }
  std::string text() {
    std::vector<int> number(places_.size()), order(places_.size());
    std::iota(number.begin(), number.end(), 1), std::iota(order.begin(), order.end(), 0);
    std::shuffle(number.begin(), number.end(), random_), std::shuffle(order.begin(), order.end(), random_);
    std::shuffle(elements_.begin(), elements_.end(), random_);
    std::string text = fmt::format("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n{}\n", names_.size());
    for (const auto& [name, tag] : names_) text += fmt::format("1 {} \"{}\"\n", tag, name);
    text += fmt::format("$EndPhysicalNames\n$Nodes\n{}\n", places_.size());
    for (const int n : order)
      text += fmt::format("{} {}\n", number[static_cast<std::size_t>(n)], places_[static_cast<std::size_t>(n)]);
    text += fmt::format("$EndNodes\n$Elements\n{}\n", elements_.size());
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      text += fmt::format("{} {} 2 {} 1", e + 1, elements_[e].type, elements_[e].tag);
      for (const int n : elements_[e].nodes) text += fmt::format(" {}", number[static_cast<std::size_t>(n)]);
      text += "\n";
    }
    return text + "$EndElements\n";
  }

 private:
  struct Element {
    int type, tag;
    std::vector<int> nodes;
  };
  void add_sides(ElementKind kind, const std::string& name, const Sides& sides, int first) {
    const int tag = names_.emplace(name, 100 + static_cast<int>(names_.size())).first->second;
    const auto count = static_cast<std::size_t>(side_node_count_of(kind));
    for (std::size_t s = 0; s < sides.size(); s += count) {
      std::vector<int> nodes{first + sides[s], first + sides[s + count - 1]};
      if (count == 3) nodes.push_back(first + sides[s + 1]);
      elements_.push_back({count == 2 ? 1 : 8, tag, nodes});
    }
  }

  std::mt19937 random_;
  std::vector<std::string> places_;
  std::vector<Element> elements_;
  std::map<std::string, int> names_;
};

}  // namespace

std::string gmsh_text(const std::vector<PlacedMesh>& meshes, unsigned seed) {
  Writer writer(seed);
  for (const PlacedMesh& mesh : meshes) writer.add(mesh);
  return writer.text();
}

}  // namespace tether::cases
