// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/tracers.hpp"

#include "base/blocks.hpp"
#include "fields/columns.hpp"
#include "physics/flow/elements.hpp"

namespace tether::fem {
namespace {

/// The solids in the shape that their nodes at q give them.
class Shape {
 public:
  Shape(const Solids& solids, const std::vector<double>& q) : mesh_(solids.mesh) {
    mesh_.x = q;
    if (!is_simplex(mesh_.kind)) finder_.emplace(mesh_);
  }
  Shape(const Shape&) = delete;
  Shape& operator=(const Shape&) = delete;

  bool holds(const Vec<2>& x) const {
    if (finder_) return finder_->find(x).has_value();
    for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
      if (triangle_holds(e, x)) return true;
    }
    return false;
  }

 private:
  /// Returns whether the place is on the left of all three edges.
  bool triangle_holds(std::size_t e, const Vec<2>& x) const {
    const int* nodes = mesh_.element(e);
    for (int k = 0; k < 3; ++k) {
      const double* a = &mesh_.x[2 * static_cast<std::size_t>(nodes[k])];
      const double* b = &mesh_.x[2 * static_cast<std::size_t>(nodes[(k + 1) % 3])];
      if ((b[0] - a[0]) * (x[1] - a[1]) < (b[1] - a[1]) * (x[0] - a[0])) return false;
    }
    return true;
  }

  Mesh mesh_;
  std::optional<PointFinder> finder_;  // of quadrilaterals
};

/// What fields of tracers are made from.
struct TracerSource {
  const FlowState& state;
  std::vector<Vec<2>> velocity;
};

const ColumnTable<ColumnSetting, TracerSource>& tracer_table() {
  using S = TracerSource;
  using Row = Column<ColumnSetting, S>;
  using D = Dimension;
  const auto place = [](const S& s, std::size_t axis, std::size_t n) { return s.state.tracers[2 * n + axis]; };
  const auto velocity = [](const S& s, std::size_t axis, std::size_t n) { return s.velocity[n][axis]; };
  static const ColumnTable<ColumnSetting, S> table({{{
      Row("", D::length, "place", place).vector(),
      {"id", D::whole, "number of the tracer, from 1", [](const S&, std::size_t n) { return n + 1; }},
      Row("v", D::velocity, "velocity", velocity).vector(),
      {"left", D::number, "1 of tracers that left the fluid's mesh, which stay where they did",
       [](const S& s, std::size_t n) { return s.state.tracer_left[n]; }},
  }}});
  return table;
}

}  // namespace

FlowTracers::FlowTracers(const Flow& flow) : flow_(flow), finder_(flow.mesh) {}

void FlowTracers::start(const Solids* solids, FlowState& state) const {
  const auto& [count, box] = flow_.tracers;
  if (count[0] == 0) return;
  std::optional<Shape> shape;
  if (solids) shape.emplace(*solids, state.q);
  for (int j = 0; j < count[1]; ++j) {
    for (int i = 0; i < count[0]; ++i) {
      const Vec<2> x{box.low[0] + (i + 0.5) * (box.high[0] - box.low[0]) / count[0],
                     box.low[1] + (j + 0.5) * (box.high[1] - box.low[1]) / count[1]};
      if (!finder_.find(x) || (shape && shape->holds(x))) continue;
      state.tracers.insert(state.tracers.end(), x.begin(), x.end());
    }
  }
  state.tracer_left.assign(state.tracers.size() / 2, 0);
}

Vec<2> FlowTracers::velocity(std::span<const double> v, const PointFinder::Found& at) const {
  Vec<2> sum{};
  const int* nodes = flow_.mesh.element(static_cast<std::size_t>(at.element));
  const auto add = [&](const auto& N) {
    for (std::size_t a = 0; a < N.size(); ++a) {
      for (std::size_t i = 0; i < 2; ++i) sum[i] += N[a] * v[2 * static_cast<std::size_t>(nodes[a]) + i];
    }
  };
  with_values_at(flow_.mesh.kind, at.s, add);
  return sum;
}

void FlowTracers::advance(Team& team, FlowState& state, double dt) const {
  if (state.tracers.empty()) return;
  std::vector<double> mean(state.v.size());
  for (std::size_t k = 0; k < mean.size(); ++k) mean[k] = 0.5 * (state.v_before[k] + state.v[k]);
  each_block(
      team, state.tracer_left.size(),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t n = begin; n < end; ++n) {
          if (state.tracer_left[n] == 0) state.tracer_left[n] = move(mean, dt, &state.tracers[2 * n]) ? 0 : 1;
        }
      },
      tracers_of_a_block);
}

/// False where it leaves the mesh. One that is in no element stays where it is.
bool FlowTracers::move(std::span<const double> mean, double dt, double* x) const {
  const auto at = finder_.find({x[0], x[1]});
  if (!at) return true;
  const auto first = velocity(mean, *at);
  const auto middle = finder_.find({x[0] + 0.5 * dt * first[0], x[1] + 0.5 * dt * first[1]});
  const auto v = middle ? velocity(mean, *middle) : first;
  x[0] += dt * v[0], x[1] += dt * v[1];
  return finder_.find({x[0], x[1]}).has_value();
}

std::size_t FlowTracers::count_inside(const Solids& solids, const FlowState& state) const {
  const Shape shape(solids, state.q);
  std::size_t count = 0;
  for (std::size_t n = 0; n < state.tracer_left.size(); ++n)
    count += shape.holds({state.tracers[2 * n], state.tracers[2 * n + 1]}) ? 1U : 0U;
  return count;
}

Snapshot FlowTracers::fields(const FlowState& state) const {
  const std::size_t count = state.tracer_left.size();
  if (count == 0) return {state.time, {}};
  TracerSource source{state, {}};
  for (std::size_t n = 0; n < count; ++n) {
    const auto at = finder_.find({state.tracers[2 * n], state.tracers[2 * n + 1]});
    source.velocity.push_back(at && state.tracer_left[n] == 0 ? velocity(state.v, *at) : Vec<2>{});
  }
  return Columns<TracerSource>(tracer_table(), ColumnSetting{}).snapshot(state.time, count, source);
}

}  // namespace tether::fem
