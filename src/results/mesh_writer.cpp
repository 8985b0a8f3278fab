// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/mesh_writer.hpp"

#include <numeric>

namespace tether {
namespace {

/// Nodes of the elements, element by element: as many as `count` in VTK's order.
FixedNumbers nodes_of_elements(const Mesh& mesh, const char* name, const char* axis, std::size_t count,
                               const char* meaning) {
  const auto nodes = nodes_in_vtk_order(mesh, count);
  return {name,
          {{"element", mesh.element_count()}, {axis, count}},
          {nodes.begin(), nodes.end()},
          {{"start_index", 0}, {"long_name", meaning}}};
}

bool of_order_2(const Mesh& mesh) { return row_of(mesh.kind).order == 2; }

/// Returns what the topology says: UGRID knows corners alone, which VTK counts first.
FixedNumbers corners_of_elements(const Mesh& mesh) {
  const bool plane = mesh.dim() == 2;
  const std::size_t all = vtk_order(mesh.kind).size(), corners = static_cast<std::size_t>(corner_count_of(mesh.kind));
  FixedNumbers nodes =
      of_order_2(mesh)
          ? nodes_of_elements(mesh, "element_corners", "corner", corners, "corners of the elements, from 0")
          : nodes_of_elements(mesh, "element_nodes", "node_of_element", all, "nodes of the elements, from 0");
  nodes.attributes.emplace_back("cf_role", plane ? "face_node_connectivity" : "volume_node_connectivity");
  return nodes;
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
                                    {plane ? "face_node_connectivity" : "volume_node_connectivity",
                                     of_order_2(mesh) ? "element_corners" : "element_nodes"},
                                    {plane ? "face_dimension" : "volume_dimension", "element"}}},
                                  corners_of_elements(mesh),
                                  {"element_region",
                                   {{"element", mesh.element_count(), {}}},
                                   {mesh.region.begin(), mesh.region.end()},
                                   {{"long_name", "region of the deck that each element belongs to, from 0"},
                                    {"mesh", "mesh"},
                                    {"location", plane ? "face" : "volume"}}}};
  if (of_order_2(mesh))
    parts.push_back(nodes_of_elements(mesh, "element_nodes", "node_of_element", vtk_order(mesh.kind).size(),
                                      "all nodes of the elements, from 0, in the order of VTK"));
  for (int axis = 0; axis < mesh.dim(); ++axis) parts.push_back(places_of(mesh, axis, units));
  return parts;
}

}  // namespace

MeshWriter::MeshWriter(std::filesystem::path folder, std::string name, Provenance provenance, VtkFiles vtk)
    : folder_(std::move(folder)),
      name_(std::move(name)),
      provenance_(std::move(provenance)),
      vtk_(folder_, name_, "vtu", vtk) {}

void MeshWriter::append(const Mesh& mesh, const Snapshot& snapshot) {
  if (!file_) {
    const FixedPart fixed{
        topology(mesh, provenance_.units), {{"mesh", "mesh"}, {"location", "node"}}, "CF-1.10 UGRID-1.0"};
    file_.emplace(folder_ / (name_ + ".nc"), std::vector<Axis>{{"node", mesh.node_count(), {}}}, snapshot, provenance_,
                  fixed);
  }
  vtk_.append(
      *file_, [&] { return vtk_of_mesh(mesh); }, snapshot);
}

void MeshWriter::close() {
  if (file_) file_->close();
}

}  // namespace tether
