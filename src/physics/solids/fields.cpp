// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solids/fields.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace tether::fem {
namespace {

using D = Dimension;

/// What fields of nodes are made from.
struct NodeSource {
  const Mesh& mesh;
  std::span<const double> q, v;
  std::vector<double> stress = {};  ///< seven numbers a node: Elements::nodal_stress
  const contact::ContactNumbers* contact = nullptr;
};

using NodeGroup = ColumnGroup<ColumnSetting, NodeSource>;

/// Number k of an array with a vector for each node.
double component(std::span<const double> values, const Mesh& mesh, std::size_t axis, std::size_t k) {
  return values[k * static_cast<std::size_t>(mesh.dim()) + axis];
}

NodeGroup motion_group() {
  using S = NodeSource;
  using Row = Column<ColumnSetting, NodeSource>;
  const auto place = [](const S& s, std::size_t axis, std::size_t k) { return component(s.q, s.mesh, axis, k); };
  const auto way = [](const S& s, std::size_t axis, std::size_t k) {
    return component(s.q, s.mesh, axis, k) - component(s.mesh.x, s.mesh, axis, k);
  };
  const auto velocity = [](const S& s, std::size_t axis, std::size_t k) { return component(s.v, s.mesh, axis, k); };
  return {{Row("", D::length, "place", place).vector(), Row("u", D::length, "displacement", way).vector(),
           Row("v", D::velocity, "velocity", velocity).vector()}};
}

/// Von Mises' equivalent of the stresses xx, yy, zz, xy, yz, xz.
double mises(const double* s) {
  const double normal = std::pow(s[0] - s[1], 2) + std::pow(s[1] - s[2], 2) + std::pow(s[2] - s[0], 2);
  return std::sqrt(0.5 * normal + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

NodeGroup contact_group() {
  using Row = Column<ColumnSetting, NodeSource>;
  const auto row = [](const char* name, D dimension, const char* meaning,
                      std::vector<double> contact::ContactNumbers::*values) {
    return Row(name, dimension, meaning,
               [values](const NodeSource& s, std::size_t k) { return (s.contact->*values)[k]; });
  };
  return {{row("contact_pressure", D::stress,
               "pressure by surfaces that meet, per area of the shape at the start, the mean near the node",
               &contact::ContactNumbers::pressure),
           row("contact_friction", D::stress, "friction of these, likewise", &contact::ContactNumbers::friction),
           row("contact_distance", D::length, "least distance from another surface, at most the gap of $contact",
               &contact::ContactNumbers::distance)}};
}

NodeGroup stress_group() {
  using Row = Column<ColumnSetting, NodeSource>;
  const auto stress = [](const char* name, std::size_t part) {
    const auto value = [part](const NodeSource& s, std::size_t k) { return s.stress[stress_fields * k + part]; };
    return Row(name, D::stress, "Cauchy's stress, the mean of the elements that meet", value);
  };
  const auto equivalent = [](const NodeSource& s, std::size_t k) { return mises(&s.stress[stress_fields * k]); };
  const auto density = [](const NodeSource& s, std::size_t k) { return s.stress[stress_fields * k + energy_field]; };
  return {{stress("sxx", 0), stress("syy", 1), stress("szz", 2), stress("sxy", 3), stress("syz", 4).when(in_space()),
           stress("sxz", 5).when(in_space()),
           Row("mises", D::stress, "von Mises' equivalent of these stresses", equivalent),
           Row("energy_density", D::stress, "strain energy per volume of the shape at the start", density)}};
}

Snapshot snapshot_of(const ColumnTable<ColumnSetting, NodeSource>& table, double time, const NodeSource& source) {
  const ColumnSetting setting{source.mesh.dim(), {}, {}};
  return Columns<NodeSource>(table, setting).snapshot(time, source.mesh.node_count(), source);
}

}  // namespace

MeshGroup shape_columns() {
  using Row = Column<ColumnSetting, MeshSums>;
  return {{{"element_quality", D::number, "least volume of an element over that at the start", &MeshSums::least},
           Row("body_volume", D::volume, "volume of the body's shape, in the plane per unit depth",
               [](const MeshSums& s, std::size_t b) { return s.volumes.at(b); })
               .each(Per::body)}};
}

MeshGroup overlap_columns() {
  return {{{"nodes_inside", D::number,
            "nodes of the bodies that lie inside another of them, or inside their own that has come through itself; of "
            "explicit steps at every 16th",
            &MeshSums::nodes_inside}}};
}

MeshSetting mesh_setting(const Solids& solids, std::vector<std::string> bodies) {
  MeshSetting setting{{solids.mesh.dim(), std::move(bodies), {}}, solids.contact.has_value()};
  for (const TrackedPlace& tracked : solids.tracked) setting.point_names.push_back(tracked.name);
  return setting;
}

std::vector<std::string> region_names(const Solids& solids) {
  std::vector<std::string> names;
  for (const SolidRegion& region : solids.regions) names.push_back(region.name);
  return names;
}

std::vector<TrackedSums> tracked_of(const Solids& solids, std::span<const double> q, std::span<const double> v) {
  const auto d = static_cast<std::size_t>(solids.mesh.dim());
  std::vector<TrackedSums> all;
  for (const TrackedPlace& tracked : solids.tracked) {
    TrackedSums& one = all.emplace_back();
    for (std::size_t i = 0; i < d; ++i)
      one.place[i] = tracked.place.of(q, d, i), one.velocity[i] = tracked.place.of(v, d, i);
  }
  return all;
}

BodySums body_of(double mass, std::span<const double> parts, std::span<const double> q, std::span<const double> v,
                 std::size_t dim) {
  const double sum = std::accumulate(parts.begin(), parts.end(), 0.0);
  BodySums body{.mass = mass};
  for (std::size_t i = 0; i < dim; ++i) {
    for (std::size_t n = 0; n < parts.size(); ++n) {
      body.place[i] += parts[n] * q[n * dim + i];
      body.velocity[i] += parts[n] * v[n * dim + i];
    }
    body.place[i] /= sum, body.velocity[i] /= sum;
  }
  return body;
}

Snapshot motion_fields(double time, const Mesh& mesh, std::span<const double> q, std::span<const double> v) {
  static const ColumnTable<ColumnSetting, NodeSource> table({motion_group()});
  return snapshot_of(table, time, {mesh, q, v});
}

Snapshot shape_fields(double time, const Mesh& mesh, const Elements& elements, std::span<const double> q,
                      std::span<const double> v, const contact::ContactNumbers* contact) {
  static const ColumnTable<ColumnSetting, NodeSource> alone({motion_group(), stress_group()}),
      that_meet({motion_group(), stress_group(), contact_group()});
  return snapshot_of(contact ? that_meet : alone, time, {mesh, q, v, elements.nodal_stress(q), contact});
}

namespace {

Components node_vector(std::span<const double> q, std::size_t node, int dim) {
  Components v{};
  for (int i = 0; i < dim; ++i)
    v[static_cast<std::size_t>(i)] = q[node * static_cast<std::size_t>(dim) + static_cast<std::size_t>(i)];
  return v;
}

/// Sums over all nodes with their momenta M v: m v, and x cross m v.
void add_motion(const SolidState& state, const SolidSystem& system, const std::vector<double>& momenta, SolidSums& s) {
  for (std::size_t n = 0; n < system.weights.size(); ++n) {
    const auto x = node_vector(state.q, n, system.dim()), p = node_vector(momenta, n, system.dim());
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      s.momentum[i] += p[i], s.angular[i] += x[j] * p[k] - x[k] * p[j];
    }
  }
}

ColumnGroup<ColumnSetting, SolidSums> work_columns() {
  const auto row = [](const char* name, const char* what, double SolidSums::*number, Book book) {
    return Column<ColumnSetting, SolidSums>(name, D::energy, what, number).booked(book);
  };
  return {{row("energy_loads", "work that loads have done on the bodies", &SolidSums::of_loads, Book::gained),
           row("energy_supports", "work of supports and walls that move", &SolidSums::of_supports, Book::gained),
           row("energy_damped", "energy that damping and backward Euler have taken", &SolidSums::damped, Book::given)}};
}

/// The supports of the deck, whose numbers ascend, and then walls: numbers of solids.supports.
std::vector<std::size_t> supports_in_order(const Solids& solids) {
  std::vector<std::size_t> order(solids.supports.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_partition(order.begin(), order.end(), [&](std::size_t s) { return solids.supports[s].number > 0; });
  return order;
}

/// "force of support 2 on the bodies in the last step".
std::string support_meaning(const SolidSetting& setting, std::size_t k) {
  return fmt::format("force of {} on the bodies in the last step", setting.support_names[k]);
}

ColumnGroup<SolidSetting, SolidSums> support_columns() {
  using Row = Column<SolidSetting, SolidSums>;
  const auto force = [](const SolidSums& s, std::size_t axis, std::size_t k) { return s.supports.at(k).force[axis]; };
  const auto torque = [](const SolidSums& s, std::size_t axis, std::size_t k) { return s.supports.at(k).torque[axis]; };
  constexpr const char* torque_meaning = "its torque about the mean place of its nodes at the start";
  return numbered<SolidSetting, SolidSums>(
      {{"of supports and walls that hold nodes", [](const SolidSetting& s) { return s.support_names.size(); }},
       {Row("support_force_", D::force,
            "force of support k of the deck, or of a wall after these, on the bodies: the mean of the last step, by "
            "central differences at its end; a node that several hold counts to the last of them",
            force)
            .vector()
            .meaning_of(support_meaning),
        Row("support_torque_", D::torque, torque_meaning, torque).vector().when(in_space()),
        Row("support_torque_z", D::torque, torque_meaning, [](const SolidSums& s, std::size_t k) {
          return s.supports.at(k).torque[2];
        }).when(in_plane())}});
}

/// Sums of what holds the nodes of each support.
std::vector<SupportSums> supports_of(const SolidState& state, const SolidSystem& system) {
  const Solids& solids = system.solids;
  const auto d = static_cast<std::size_t>(system.dim());
  std::vector<SupportSums> all;
  for (const std::size_t number : supports_in_order(solids)) {
    const std::vector<int>& nodes = solids.supports[number].nodes;
    SupportSums& sums = all.emplace_back();
    Components centre{};
    for (const int node : nodes) {
      const Components x = node_vector(solids.mesh.x, static_cast<std::size_t>(node), system.dim());
      for (std::size_t i = 0; i < 3; ++i) centre[i] += x[i] / static_cast<double>(nodes.size());
    }
    for (const int node : nodes) {
      const Components q = node_vector(state.q, static_cast<std::size_t>(node), system.dim());
      Components force{};
      for (std::size_t i = 0; i < d; ++i) {
        const std::size_t k = static_cast<std::size_t>(node) * d + i;
        if (system.holder[k] == static_cast<int>(number)) force[i] = state.hold[k];
      }
      const Vec<3> torque = cross(minus(q, centre), force);
      for (std::size_t i = 0; i < 3; ++i) sums.force[i] += force[i], sums.torque[i] += torque[i];
    }
  }
  return all;
}

/// M v, by the masses that the integrator moves.
std::vector<double> momenta_of(const SolidState& state, const SolidSystem& system) {
  const auto d = static_cast<std::size_t>(system.dim());
  std::vector<double> momenta(state.v.size());
  if (system.solids.integrator == Integrator::central) {
    for (std::size_t k = 0; k < momenta.size(); ++k) momenta[k] = system.lumped[k / d] * state.v[k];
  } else {
    system.multiply_mass(state.v, momenta);
  }
  return momenta;
}

}  // namespace

const ColumnTable<SolidSetting, SolidSums>& solid_table() {
  static const ColumnTable<SolidSetting, SolidSums> table(
      {energy_columns(), work_columns(), contact_columns(), momentum_columns(), given(in_space(), spin_columns()),
       given(in_plane(), plane_spin_column()), overlap_columns(), shape_columns(), body_columns(), tracked_columns(),
       support_columns()});
  return table;
}

Columns<SolidSums> solid_columns(const Solids& solids) {
  SolidSetting setting{mesh_setting(solids, region_names(solids)), {}};
  for (const std::size_t s : supports_in_order(solids))
    setting.support_names.push_back(solids.supports[s].amplitude.of);
  return {solid_table(), std::move(setting)};
}

SolidSums sums_of(const SolidState& state, const SolidSystem& system) {
  const std::vector<double> momenta = momenta_of(state, system);
  SolidSums s;
  s.time = state.time, s.dt = state.dt_last;
  for (std::size_t k = 0; k < momenta.size(); ++k) s.kinetic += 0.5 * momenta[k] * state.v[k];
  s.strain = system.elements->strain_energy(state.q), s.potential = system.gravity_energy(state.q);
  s.contact = state.contact;
  s.total = s.kinetic + s.strain + s.potential + s.contact.last.energy;
  s.of_loads = state.of_loads, s.of_supports = state.of_supports, s.damped = state.damped;
  for (const auto& weights : system.region_weights) {
    const double mass = std::accumulate(weights.begin(), weights.end(), 0.0);
    s.bodies.push_back(body_of(mass, weights, state.q, state.v, static_cast<std::size_t>(system.dim())));
    s.mass += mass;
  }
  add_motion(state, system, momenta, s);
  s.nodes_inside = static_cast<double>(state.overlap.now);
  const ShapeVolumes shape = system.elements->shape(state.q);
  s.least = shape.least, s.volumes = shape.of_region;
  s.tracked = tracked_of(system.solids, state.q, state.v);
  s.supports = supports_of(state, system);
  return s;
}

std::string worst_element(const SolidSystem& system, std::span<const double> q) {
  const ShapeVolumes shape = system.elements->shape(q);
  const auto x = node_vector(q, static_cast<std::size_t>(system.solids.mesh.element(shape.worst)[0]), system.dim());
  return fmt::format("element {} at ({:.6g}, {:.6g}{})", shape.worst + 1, x[0], x[1],
                     system.dim() == 3 ? fmt::format(", {:.6g}", x[2]) : "");
}

Snapshot node_fields(const SolidState& state, const SolidSystem& system) {
  return shape_fields(state.time, system.solids.mesh, *system.elements, state.q, state.v,
                      system.solids.contact ? &state.contact.last : nullptr);
}

}  // namespace tether::fem
