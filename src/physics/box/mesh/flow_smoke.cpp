// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "physics/box/mesh/mesh_flow.hpp"
#include "physics/box/mesh/mesh_smoke.hpp"

namespace tether::coupled {

// The smoke of a flow on a mesh. It is on the mesh about the solids as they are now: a step's end carries it there.

/// A cell has the mean of what the scene has at many places within it.
void MeshFlow::start_smoke(CoupledState& state) const {
  constexpr int parts = 6;  // of each edge
  const FlowMesh& mesh = *at_.mesh;
  const auto in = [&](const Box<3>& box, const Vec<3>& x) {
    bool inside = true;
    for (std::size_t a = 0; a < at(mesh.dim); ++a) inside = inside && x[a] >= box.low[a] && x[a] <= box.high[a];
    return inside;
  };
  state.smoke = {mesh.volume, std::vector<double>(mesh.cells(), 0.0), std::vector<double>(mesh.cells(), 0.0)};
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    const std::vector<Vec<3>> places = places_in(mesh, cell, parts);
    const double volume = mesh.volume[cell] / static_cast<double>(places.size());
    for (const Vec<3>& x : places) {
      for (const SmokeBox& of : scene_.smoke_boxes) {
        if (!in(of.box, x)) continue;
        state.smoke.smoke[cell] += volume * of.density, state.smoke.heat[cell] += volume * of.temperature;
      }
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
