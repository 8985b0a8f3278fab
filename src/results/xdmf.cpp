// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/xdmf.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace tether {
namespace {

/// Lengths along the dimensions, slowest first.
using Shape = std::vector<std::size_t>;

/// One record of a field: its lengths in the file, and as the topology of the XDMF grid counts them.
struct Layout {
  Shape in_file, in_grid;
  Shape taken = {};  // of in_file, where that is not all
};

/// One record of a variable: a slab of the whole data set, given by start, stride and count along each dimension.
std::string record_item(const XdmfSeries& series, const std::string& field, std::size_t record, const Layout& layout) {
  const Shape& shape = layout.in_file;
  const Shape zeros(shape.size(), 0), ones(shape.size() + 1, 1);
  std::string text = fmt::format("<DataItem ItemType=\"HyperSlab\" Type=\"HyperSlab\" Dimensions=\"{}\">\n",
                                 fmt::join(layout.in_grid, " "));
  text += fmt::format("<DataItem Dimensions=\"3 {}\" NumberType=\"Int\" Format=\"XML\">{} {} {} 1 {}</DataItem>\n",
                      shape.size() + 1, record, fmt::join(zeros, " "), fmt::join(ones, " "),
                      fmt::join(layout.taken.empty() ? shape : layout.taken, " "));
  text += fmt::format(
      "<DataItem Dimensions=\"{} {}\" NumberType=\"Float\" Precision=\"8\" Format=\"HDF\">{}:/{}</DataItem>\n",
      series.times.size(), fmt::join(shape, " "), series.file, field);
  return text + "</DataItem>\n";
}

std::string attribute(const XdmfSeries& series, const std::string& field, std::size_t record, const Layout& layout) {
  return fmt::format("<Attribute Name=\"{}\" AttributeType=\"Scalar\" Center=\"Node\">\n{}</Attribute>\n", field,
                     record_item(series, field, record, layout));
}

/// One uniform grid a record of this layout; `place` writes its topology and geometry.
template <class LayoutOf, class Place>
std::string collection_of(const XdmfSeries& series, LayoutOf layout_of, Place place) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n<Domain>\n"
      "<Grid Name=\"series\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (std::size_t record = 0; record < series.times.size(); ++record) {
    text += fmt::format("<Grid Name=\"record\" GridType=\"Uniform\">\n<Time Value=\"{}\"/>\n", series.times[record]);
    text += place(record);
    for (const auto& field : series.fields) text += attribute(series, field, record, layout_of(record));
    text += "</Grid>\n";
  }
  return text + "</Grid>\n</Domain>\n</Xdmf>\n";
}

template <class Place>
std::string collection(const XdmfSeries& series, const Layout& layout, Place place) {
  return collection_of(
      series, [&layout](std::size_t) { return layout; }, place);
}

}  // namespace

std::string xdmf_points(const XdmfSeries& series, const std::vector<std::size_t>& counts) {
  const std::size_t most = counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end());
  const auto layout_of = [&](std::size_t record) { return Layout{{most}, {counts[record]}, {counts[record]}}; };
  return collection_of(series, layout_of, [&](std::size_t record) {
    const Layout layout = layout_of(record);
    return fmt::format("<Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{}\"/>\n", counts[record]) +
           "<Geometry GeometryType=\"X_Y\">\n" + record_item(series, "x", record, layout) +
           record_item(series, "y", record, layout) + "</Geometry>\n";
  });
}

std::string xdmf_grid(const XdmfSeries& series, const BackgroundGrid& grid) {
  // XDMF counts the slowest direction first: z, y, x. The grid is given as one layer of a 3D one, for ParaView lays a
  // 2DCORECTMesh into the y-z plane, away from the points.
  const auto triple = [](double z, double y, double x) {
    return fmt::format(
        "<DataItem Dimensions=\"3\" NumberType=\"Float\" Precision=\"8\" Format=\"XML\">{} {} {}</DataItem>\n", z, y,
        x);
  };
  const auto nx = static_cast<std::size_t>(grid.nx), ny = static_cast<std::size_t>(grid.ny);
  return collection(series, {{ny, nx}, {1, ny, nx}}, [&](std::size_t) {
    return fmt::format("<Topology TopologyType=\"3DCORECTMesh\" Dimensions=\"1 {} {}\"/>\n", ny, nx) +
           "<Geometry GeometryType=\"ORIGIN_DXDYDZ\">\n" + triple(0, grid.y0, grid.x0) + triple(1, grid.dy, grid.dx) +
           "</Geometry>\n";
  });
}

namespace {

const char* topology_name(ElementKind kind) {
  constexpr const char* names[] = {"Quadrilateral", "Quadrilateral_9", "Triangle",
                                   "Hexahedron",    "Hexahedron_27",   "Tetrahedron"};
  return names[static_cast<int>(kind)];
}

}  // namespace

std::string xdmf_mesh(const XdmfSeries& series, const Mesh& mesh) {
  const std::size_t nodes = mesh.node_count(), elements = mesh.element_count();
  const Layout layout{{nodes}, {nodes}};
  const auto shape = fmt::format("{} {}", elements, node_count_of(mesh.kind));
  return collection(series, layout, [&](std::size_t record) {
    std::string text = fmt::format(
        "<Topology TopologyType=\"{}\" NumberOfElements=\"{}\">\n<DataItem Dimensions=\"{}\" NumberType=\"Int\" "
        "Format=\"HDF\">{}:/element_nodes</DataItem>\n</Topology>\n<Geometry GeometryType=\"{}\">\n",
        topology_name(mesh.kind), elements, shape, series.file, mesh.dim() == 2 ? "X_Y" : "X_Y_Z");
    for (const char* axis : {"x", "y", "z"}) {
      if (mesh.dim() == 3 || *axis != 'z') text += record_item(series, axis, record, layout);
    }
    return text + "</Geometry>\n";
  });
}

}  // namespace tether
