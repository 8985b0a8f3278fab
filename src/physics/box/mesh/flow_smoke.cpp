// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/numbers.hpp"
#include "physics/box/mesh/mesh_flow.hpp"
#include "physics/box/mesh/mesh_smoke.hpp"

namespace tether::coupled {

// The smoke of a flow on a mesh. It is on the mesh about the solids as they are now: a step's end carries it there.

namespace {

/// What of a polygon lies on a side of a line across an axis (I. Sutherland, G. Hodgman 1974).
std::vector<Vec<3>> part_beyond(std::span<const Vec<3>> polygon, std::size_t axis, double level, double sign) {
  std::vector<Vec<3>> part;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec<3>&a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double of_a = sign * (a[axis] - level), of_b = sign * (b[axis] - level);
    if (of_a >= 0) part.push_back(a);
    if (of_a * of_b >= 0) continue;
    const double way = of_a / (of_a - of_b);
    part.push_back({a[0] + way * (b[0] - a[0]), a[1] + way * (b[1] - a[1]), 0});
  }
  return part;
}

/// The part of a triangle that lies in a box, from 0 to 1.
double part_of_triangle(const FlowMesh& mesh, std::size_t cell, const Box<3>& box) {
  std::vector<Vec<3>> polygon;
  for (const int n : mesh.nodes_of(cell)) polygon.push_back(mesh.x[at(n)]);
  for (const std::size_t axis : {0U, 1U}) {
    polygon = part_beyond(polygon, axis, box.low[axis], 1);
    polygon = part_beyond(polygon, axis, box.high[axis], -1);
  }
  double twice = 0;
  for (std::size_t k = 2; k < polygon.size(); ++k)
    twice += cross(minus(polygon[k - 1], polygon[0]), minus(polygon[k], polygon[0]))[2];
  return 0.5 * twice / mesh.volume[cell];
}

/// Places spread over a tetrahedron, so many along each edge, whose mean is its middle.
std::vector<Vec<3>> places_in(const FlowMesh& mesh, std::size_t cell, int along) {
  std::vector<Vec<3>> places;
  const auto nodes = mesh.nodes_of(cell);
  for (int i = 0; i < along; ++i) {
    for (int j = 0; i + j < along; ++j) {
      for (int k = 0; i + j + k < along; ++k) {
        const std::array<double, 4> share{(i + 0.25) / along, (j + 0.25) / along, (k + 0.25) / along,
                                          (along - i - j - k - 0.75) / along};
        Vec<3> x{};
        for (std::size_t n = 0; n < 4; ++n) {
          for (std::size_t a = 0; a < 3; ++a) x[a] += share[n] * mesh.x[at(nodes[n])][a];
        }
        places.push_back(x);
      }
    }
  }
  return places;
}

/// The part of a tetrahedron, by places spread over it.
double part_of_tetrahedron(const FlowMesh& mesh, std::size_t cell, const Box<3>& box) {
  constexpr int along = 8;  // each edge
  const std::vector<Vec<3>> places = places_in(mesh, cell, along);
  const auto inside = std::ranges::count_if(places, [&](const Vec<3>& x) {
    bool in = true;
    for (std::size_t a = 0; a < 3; ++a) in = in && x[a] >= box.low[a] && x[a] <= box.high[a];
    return in;
  });
  return static_cast<double>(inside) / static_cast<double>(places.size());
}

}  // namespace

/// A cell that lies in a box in part has that part of its smoke.
void MeshFlow::start_smoke(CoupledState& state) const {
  const FlowMesh& mesh = *at_.mesh;
  state.smoke = {mesh.volume, std::vector<double>(mesh.cells(), 0.0), std::vector<double>(mesh.cells(), 0.0)};
  for (const SmokeBox& of : scene_.smoke_boxes) {
    for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
      const double part =
          mesh.dim == 2 ? part_of_triangle(mesh, cell, of.box) : part_of_tetrahedron(mesh, cell, of.box);
      state.smoke.smoke[cell] += part * mesh.volume[cell] * of.density;
      state.smoke.heat[cell] += part * mesh.volume[cell] * of.temperature;
    }
  }
}

/// What is beyond open sides lies in layers, as rows of the grid's cells.
double MeshFlow::outside_at(double y, double (Outside::*of)(int row) const) const {
  const StaggeredGrid& grid = scene_.grid;
  return (outside_.*of)(std::clamp(static_cast<int>((y - grid.low[1]) / grid.d[1]), 0, grid.n[1] - 1));
}

void MeshFlow::carry_smoke_to(const FlowMesh& next, double h, CoupledState& state) const {
  const FlowMesh& mesh = *at_.mesh;
  std::vector<FaceValue> smoke, heat;
  each_prescribed(state.v, [&](std::size_t face, double) {
    const Jet& jet = scene_.jets[at(jet_at(scene_, mesh.boundary[face].number, mesh.middle_of_face(face)))];
    smoke.push_back({face, jet.smoke}), heat.push_back({face, jet.temperature});
  });
  each_open_side([&](std::size_t face, std::size_t, double) {
    const bool fluid = outside_.presses(mesh.boundary[face].number);
    const double y = mesh.middle_of_face(face)[1];
    smoke.push_back({face, fluid ? outside_at(y, &Outside::density) : 0});
    heat.push_back({face, fluid ? outside_at(y, &Outside::temperature) : 0});
  });
  const MeshVelocity velocity(mesh, state.v);
  const ContentCarrier carrier(mesh, state.v, velocity, next, h);
  const ContentCarrier::Carried of_smoke = carrier.carry(state.smoke.smoke, smoke),
                                of_heat = carrier.carry(state.smoke.heat, heat);
  state.smoke = {next.volume, of_smoke.content, of_heat.content};
  state.smoke_flow.smoke_in += of_smoke.in, state.smoke_flow.smoke_out += of_smoke.out;
  state.smoke_flow.heat_in += of_heat.in, state.smoke_flow.heat_out += of_heat.out;
}

}  // namespace tether::coupled
