// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/vtk_series.hpp"

#include <fmt/format.h>
#include <numeric>
#include <system_error>

#include "base/diagnostics.hpp"
#include "results/text_file.hpp"

namespace tether {
namespace {

std::vector<std::int32_t> counted(std::size_t count, std::int32_t first, std::int32_t step) {
  std::vector<std::int32_t> numbers(count);
  for (std::size_t k = 0; k < count; ++k) numbers[k] = first + static_cast<std::int32_t>(k) * step;
  return numbers;
}

/// VTK's number of a cell. Source: VTK, vtkCellType.h.
/// An image of so many intervals along x, y and z.
VtkShape image(const std::array<int, 3>& intervals, const Vec<3>& low, const Vec<3>& step, bool of_cells) {
  const std::string extent = fmt::format("0 {} 0 {} 0 {}", intervals[0], intervals[1], intervals[2]);
  return {"ImageData",
          fmt::format("WholeExtent=\"{}\" Origin=\"{} {} {}\" Spacing=\"{} {} {}\"", extent, low[0], low[1], low[2],
                      step[0], step[1], step[2]),
          fmt::format("Extent=\"{}\"", extent),
          {},
          of_cells};
}

std::string collection(const std::string& name, const std::string& ending, const std::vector<double>& times) {
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n<Collection>\n";
  for (std::size_t k = 0; k < times.size(); ++k)
    text += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}/{}-{:04}.{}\"/>\n", times[k], vtk_folder, name,
                        k, ending);
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace

std::vector<int> vtk_order(ElementKind kind) {
  const ElementRow& row = row_of(kind);
  return {row.in_vtk.begin(), row.in_vtk.begin() + row.nodes};
}

std::vector<std::int32_t> nodes_in_vtk_order(const Mesh& mesh, std::size_t count) {
  const std::vector<int> order = vtk_order(mesh.kind);
  std::vector<std::int32_t> nodes;
  nodes.reserve(mesh.element_count() * count);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (std::size_t a = 0; a < count; ++a) nodes.push_back(mesh.element(e)[order[a]]);
  }
  return nodes;
}

VtkShape vtk_of_points(std::size_t count) {
  return {"PolyData",
          "",
          fmt::format("NumberOfPoints=\"{0}\" NumberOfVerts=\"{0}\"", count),
          {{"Verts", "connectivity", counted(count, 0, 1)}, {"Verts", "offsets", counted(count, 1, 1)}}};
}

VtkShape vtk_of_facets(std::size_t count, int corners) {
  const char* section = corners == 2 ? "Lines" : "Polys";
  const std::size_t facets = count / static_cast<std::size_t>(corners);
  return {"PolyData",
          "",
          fmt::format("NumberOfPoints=\"{}\" NumberOf{}=\"{}\"", count, section, facets),
          {{section, "connectivity", counted(count, 0, 1)}, {section, "offsets", counted(facets, corners, corners)}}};
}

VtkShape vtk_of_simplices(std::size_t count, int corners) {
  constexpr std::uint8_t triangle = 5, tetrahedron = 10;  // VTK's numbers of them
  const std::size_t cells = count / static_cast<std::size_t>(corners);
  return {"UnstructuredGrid",
          "",
          fmt::format("NumberOfPoints=\"{}\" NumberOfCells=\"{}\"", count, cells),
          {{"Cells", "connectivity", counted(count, 0, 1)},
           {"Cells", "offsets", counted(cells, corners, corners)},
           {"Cells", "types", std::vector<std::uint8_t>(cells, corners == 3 ? triangle : tetrahedron)}}};
}

VtkShape vtk_of_mesh(const Mesh& mesh) {
  const std::size_t elements = mesh.element_count(), nodes = vtk_order(mesh.kind).size();
  const auto per_element = static_cast<std::int32_t>(nodes);
  return {
      "UnstructuredGrid",
      "",
      fmt::format("NumberOfPoints=\"{}\" NumberOfCells=\"{}\"", mesh.node_count(), elements),
      {{"CellData", "region", std::vector<std::int32_t>(mesh.region.begin(), mesh.region.end())},
       {"Cells", "connectivity", nodes_in_vtk_order(mesh, nodes)},
       {"Cells", "offsets", counted(elements, per_element, per_element)},
       {"Cells", "types", std::vector<std::uint8_t>(elements, static_cast<std::uint8_t>(row_of(mesh.kind).vtk_type))}}};
}

VtkShape vtk_of_nodes(const BackgroundGrid& grid) {
  return image({grid.nx - 1, grid.ny - 1, 0}, {grid.x0, grid.y0, 0}, {grid.dx, grid.dy, 1}, false);
}

VtkShape vtk_of_cells(const StaggeredGrid& grid) {
  return image({grid.n[0], grid.n[1], grid.dim == 3 ? grid.n[2] : 0}, grid.low, grid.d, true);
}

VtkSeries::VtkSeries(std::filesystem::path folder, std::string name, std::string ending, VtkFiles wanted)
    : folder_(std::move(folder)), name_(std::move(name)), ending_(std::move(ending)), wanted_(wanted) {}

void VtkSeries::append(SnapshotFile& file, const std::function<VtkShape()>& shape, const FieldsInTurn& snapshot) {
  if (!writes_vtk(wanted_, snapshot.count())) return file.append(snapshot);
  std::error_code reason;
  std::filesystem::create_directories(folder_ / vtk_folder, reason);
  if (reason) throw FileError(fmt::format("{}: cannot be made: {}", (folder_ / vtk_folder).string(), reason.message()));
  std::vector<std::string> names;
  for (const Quantity& quantity : snapshot.quantities()) names.push_back(quantity.name);
  VtkFile vtk(folder_ / vtk_folder / fmt::format("{}-{:04}.{}", name_, times_.size(), ending_), shape(), names,
              snapshot.count());
  file.append(snapshot, [&](std::size_t field, std::span<const double> numbers) { vtk.put(field, numbers); });
  vtk.close();
  times_.push_back(snapshot.time());
  replace_file(folder_ / (name_ + ".pvd"), collection(name_, ending_, times_));
}

}  // namespace tether
