// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/mesh_writer.hpp"

#include <numeric>

#include "results/text_file.hpp"

namespace tether {
namespace {

/// The nodes of the elements, element by element.
FixedNumbers elements_of(const Mesh& mesh) {
  const std::vector<int> order = vtk_order(mesh.kind);
  const bool plane = mesh.dim() == 2;
  std::vector<double> nodes;
  nodes.reserve(mesh.nodes.size());
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (const int a : order) nodes.push_back(mesh.element(e)[a]);
  }
  return {"element_nodes",
          {{"element", mesh.element_count(), {}}, {"node_of_element", order.size(), {}}},
          std::move(nodes),
          {{"cf_role", plane ? "face_node_connectivity" : "volume_node_connectivity"},
           {"start_index", 0},
           {"long_name", "nodes of the elements, from 0"}}};
}

/// One coordinate of the nodes of the reference shape.
FixedNumbers places_of(const Mesh& mesh, int axis, Units units) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  const std::string name(1, "xyz"[axis]);
  std::vector<double> places;
  for (std::size_t n = static_cast<std::size_t>(axis); n < mesh.x.size(); n += dim) places.push_back(mesh.x[n]);
  return {"node_" + name,
          {{"node", mesh.node_count(), {}}},
          std::move(places),
          {{"units", std::string(unit_text(Dimension::length, units))},
           {"long_name", name + " of the nodes in the reference shape"}},
          false};
}

/// UGRID: the topology, which elements there are, where their nodes are, and of what region each element is.
std::vector<FixedNumbers> topology(const Mesh& mesh, Units units) {
  const bool plane = mesh.dim() == 2;
  std::vector<FixedNumbers> parts{{"mesh",
                                   {},
                                   {0},
                                   {{"cf_role", "mesh_topology"},
                                    {"topology_dimension", mesh.dim()},
                                    {"node_coordinates", plane ? "node_x node_y" : "node_x node_y node_z"},
                                    {plane ? "face_node_connectivity" : "volume_node_connectivity", "element_nodes"},
                                    {plane ? "face_dimension" : "volume_dimension", "element"}}},
                                  elements_of(mesh),
                                  {"element_region",
                                   {{"element", mesh.element_count(), {}}},
                                   {mesh.region.begin(), mesh.region.end()},
                                   {{"long_name", "region of the deck that each element belongs to, from 0"},
                                    {"mesh", "mesh"},
                                    {"location", plane ? "face" : "volume"}}}};
  for (int axis = 0; axis < mesh.dim(); ++axis) parts.push_back(places_of(mesh, axis, units));
  return parts;
}

}  // namespace

std::vector<int> vtk_order(ElementKind kind) {
  const ElementRow& row = row_of(kind);
  return {row.in_vtk.begin(), row.in_vtk.begin() + row.nodes};
}

MeshWriter::MeshWriter(std::filesystem::path folder, std::string name, Provenance provenance)
    : folder_(std::move(folder)), name_(std::move(name)), provenance_(std::move(provenance)) {}

void MeshWriter::append(const Mesh& mesh, const Snapshot& snapshot) {
  if (!file_) {
    const FixedPart fixed{
        topology(mesh, provenance_.units), {{"mesh", "mesh"}, {"location", "node"}}, "CF-1.10 UGRID-1.0"};
    file_.emplace(folder_ / (name_ + ".nc"), std::vector<Axis>{{"node", mesh.node_count(), {}}}, snapshot, provenance_,
                  fixed);
    series_ = {name_ + ".nc", {}, {}};
    for (const auto& field : snapshot.fields) series_.fields.push_back(field.quantity.name);
  }
  file_->append(snapshot);
  series_.times.push_back(snapshot.time);
  replace_file(folder_ / (name_ + ".xmf"), xdmf_mesh(series_, mesh));
}

void MeshWriter::close() {
  if (file_) file_->close();
}

}  // namespace tether
