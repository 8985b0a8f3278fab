// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/mesh_writer.hpp"

#include <numeric>

#include "results/text_file.hpp"

namespace tether {
namespace {

/// (element, node of it), from 0, and of what region each element is.
std::vector<FixedNumbers> topology(const Mesh& mesh) {
  const std::vector<int> order = vtk_order(mesh.kind);
  std::vector<double> nodes;
  nodes.reserve(mesh.nodes.size());
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (const int a : order) nodes.push_back(mesh.element(e)[a]);
  }
  const Axis elements{"element", mesh.element_count(), {}};
  const bool plane = mesh.dim() == 2;
  return {{"mesh",
           {},
           {0},
           {{"cf_role", "mesh_topology"},
            {"topology_dimension", plane ? "2" : "3"},
            {"node_coordinates", plane ? "x y" : "x y z"},
            {plane ? "face_node_connectivity" : "volume_node_connectivity", "element_nodes"}}},
          {"element_nodes",
           {elements, {"node_of_element", order.size(), {}}},
           nodes,
           {{"cf_role", plane ? "face_node_connectivity" : "volume_node_connectivity"},
            {"long_name", "nodes of the elements, from 0"}}},
          {"element_region",
           {{"element_of_region", mesh.element_count(), {}}},
           {mesh.region.begin(), mesh.region.end()},
           {{"long_name", "region of the deck that each element belongs to, from 0"}}}};
}

}  // namespace

std::vector<int> vtk_order(ElementKind kind) {
  switch (kind) {
    case ElementKind::quad4:
      return {0, 1, 3, 2};
    case ElementKind::quad9:
      return {0, 2, 8, 6, 1, 5, 7, 3, 4};
    case ElementKind::hex8:
      return {0, 1, 3, 2, 4, 5, 7, 6};
    case ElementKind::hex27:
      return {0, 2, 8, 6, 18, 20, 26, 24, 1, 5, 7, 3, 19, 23, 25, 21, 9, 11, 17, 15, 12, 14, 10, 16, 4, 22, 13};
    case ElementKind::tri3:
    case ElementKind::tet4:
      break;
  }
  std::vector<int> order(static_cast<std::size_t>(node_count_of(kind)));
  std::iota(order.begin(), order.end(), 0);
  return order;
}

MeshWriter::MeshWriter(std::filesystem::path folder, Provenance provenance)
    : folder_(std::move(folder)), provenance_(std::move(provenance)) {}

void MeshWriter::append(const Mesh& mesh, const Snapshot& snapshot) {
  if (!file_) {
    file_.emplace(folder_ / "mesh.nc", std::vector<Axis>{{"node", mesh.node_count(), {}}}, snapshot, provenance_,
                  topology(mesh),
                  std::vector<std::pair<std::string, std::string>>{{"mesh", "mesh"}, {"location", "node"}});
    series_ = {"mesh.nc", {}, {}};
    for (const auto& field : snapshot.fields) series_.fields.push_back(field.quantity.name);
  }
  file_->append(snapshot);
  series_.times.push_back(snapshot.time);
  replace_file(folder_ / "mesh.xmf", xdmf_mesh(series_, mesh));
}

void MeshWriter::close() {
  if (file_) file_->close();
}

}  // namespace tether
