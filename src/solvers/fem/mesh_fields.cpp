// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fem/mesh_fields.hpp"

#include <fmt/format.h>

#include <array>

namespace tether::fem {
namespace {

constexpr std::array axes{"x", "y", "z"};

}  // namespace

void add_vector(HistoryLayout& layout, const std::string& name, Dimension dimension, const std::string& meaning,
                int dim, Per per) {
  for (int i = 0; i < dim; ++i) {
    const std::string axis = axes[static_cast<std::size_t>(i)];
    layout.quantities.push_back({name + axis, dimension, meaning + axis, per});
  }
}

void add_energies(HistoryLayout& layout) {
  for (const Quantity& quantity : {
           Quantity{"time", Dimension::time, "time"},
           Quantity{"dt", Dimension::time, "length of the last step"},
           Quantity{"energy_kinetic", Dimension::energy, "kinetic energy"},
           Quantity{"energy_strain", Dimension::energy, "energy stored in solids"},
           Quantity{"energy_internal", Dimension::energy, "internal energy of gas: none"},
           Quantity{"energy_potential", Dimension::energy, "potential energy in gravity, zero at y = 0"},
           Quantity{"energy_total", Dimension::energy, "sum of the energies"},
       })
    layout.quantities.push_back(quantity);
}

void add_momenta(HistoryLayout& layout, int dim) {
  layout.quantities.push_back({"mass", Dimension::mass, "mass"});
  add_vector(layout, "momentum_", Dimension::momentum, "momentum in ", dim);
  if (dim == 3) {
    add_vector(layout, "angular_momentum_", Dimension::angular_momentum, "angular momentum about the origin, ", 3);
  } else {
    layout.quantities.push_back(
        {"angular_momentum_z", Dimension::angular_momentum, "angular momentum about the origin"});
  }
}

void add_overlap(HistoryLayout& layout) {
  layout.quantities.push_back(
      {"nodes_inside", Dimension::number,
       "nodes of the bodies that lie inside another of them, or inside their own that has come through itself"});
}

void add_shape(HistoryLayout& layout) {
  layout.quantities.push_back(
      {"element_quality", Dimension::number, "least volume of an element over that at the start"});
  layout.quantities.push_back(
      {"body_volume", Dimension::volume, "volume of its shape, in the plane per unit depth", Per::body});
}

void add_bodies_and_nodes(HistoryLayout& layout, const Solids& solids, const std::vector<std::string>& bodies) {
  const int dim = solids.mesh.dim();
  add_vector(layout, "body_", Dimension::length, "centre of mass, ", dim, Per::body);
  add_vector(layout, "body_v", Dimension::velocity, "velocity of the centre of mass, ", dim, Per::body);
  layout.quantities.push_back({"body_mass", Dimension::mass, "mass", Per::body});
  if (!solids.tracked.empty()) {
    add_vector(layout, "point_", Dimension::length, "place, ", dim, Per::point);
    add_vector(layout, "point_v", Dimension::velocity, "velocity, ", dim, Per::point);
  }
  layout.body_names = bodies;
  for (const TrackedPlace& tracked : solids.tracked) layout.point_names.push_back(tracked.name);
}

void append_tracked(const Solids& solids, std::span<const double> q, std::span<const double> v, Record& record) {
  const auto d = static_cast<std::size_t>(solids.mesh.dim());
  for (const auto& of : {q, v}) {
    for (std::size_t i = 0; i < d; ++i) {
      for (const TrackedPlace& tracked : solids.tracked) record.push_back(tracked.place.of(of, d, i));
    }
  }
}

Snapshot motion_fields(double time, const Mesh& mesh, std::span<const double> q, std::span<const double> v) {
  const auto d = static_cast<std::size_t>(mesh.dim());
  Snapshot snapshot;
  snapshot.time = time;
  const auto add = [&](const std::string& name, Dimension dimension, const char* meaning, auto value) {
    for (std::size_t i = 0; i < d; ++i) {
      Field field{{name + axes[i], dimension, meaning}, std::vector<double>(mesh.node_count())};
      for (std::size_t n = 0; n < field.values.size(); ++n) field.values[n] = value(n * d + i);
      snapshot.fields.push_back(std::move(field));
    }
  };
  add("", Dimension::length, "place", [&](std::size_t k) { return q[k]; });
  add("u", Dimension::length, "displacement", [&](std::size_t k) { return q[k] - mesh.x[k]; });
  add("v", Dimension::velocity, "velocity", [&](std::size_t k) { return v[k]; });
  return snapshot;
}

}  // namespace tether::fem
