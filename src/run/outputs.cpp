// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/outputs.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>

#include "base/diagnostics.hpp"
#include "base/text.hpp"
#include "model/coupled.hpp"
#include "model/flow.hpp"
#include "model/solids.hpp"
#include "run/fields_underway.hpp"

namespace tether {
namespace {

/// The folder that a checkpoint's run wrote into, whatever links led to it.
std::filesystem::path folder_of(const std::filesystem::path& checkpoint) {
  return std::filesystem::canonical(checkpoint).parent_path();
}

/// A run that goes on may find its snapshots in its folder.
EarlierSnapshots earlier_snapshots(const RunRequest& request) {
  return request.restart.empty() ? EarlierSnapshots::removed : EarlierSnapshots::set_aside;
}

constexpr std::size_t most_waiting = std::size_t{128} << 20U;  // bytes, of what waits to be written

std::size_t bytes_of(const Snapshot& snapshot) {
  std::size_t numbers = 0;
  for (const Field& field : snapshot.fields) numbers += field.values.size();
  return numbers * sizeof(double);
}

/// The mesh that the fields of Solver::grid() stand on; null for those of a regular grid.
struct MeshOfGrid {
  const Mesh* operator()(const MaterialPoints&) const { return nullptr; }
  const Mesh* operator()(const Bars&) const { return nullptr; }
  const Mesh* operator()(const ElasticBodies& bodies) const { return &bodies.solids->mesh; }
  const Mesh* operator()(const RigidBody& body) const { return &body.solids->mesh; }
  const Mesh* operator()(const MeshFlow& flow) const { return &flow.flow->mesh; }
  const Mesh* operator()(const BoxFlow&) const { return nullptr; }
};

/// Of the space that a surface or a flow lies in.
int dim_of(const Scene& scene) { return scene.coupled() == nullptr ? 2 : scene.coupled()->grid.dim; }

/// Returns whether points come and go while the scene runs.
bool points_change(const Scene& scene) {
  return scene.edges.any() || (scene.coupled() != nullptr && scene.coupled()->liquid.has_value());
}

}  // namespace

RunOutputs::RunOutputs(const Plan& plan, const RunRequest& request, const Solver& solver)
    : plan_(plan),
      request_(request),
      solver_(solver),
      folder_(request.folder, solver.history_layout(), request.provenance,
              {plan.scene.outputs.vtk, earlier_snapshots(request), points_change(plan.scene), dim_of(plan.scene)}),
      history_{solver.history_layout(), {}},
      history_due_(plan.scene.outputs.history),
      points_due_(plan.scene.outputs.points),
      grid_due_(plan.scene.outputs.grid),
      checkpoint_due_(plan.scene.outputs.checkpoint),
      queue_(most_waiting) {
  folder_.deck_effective(request.deck_effective);
  if (request.mesh_text) folder_.beside_deck(effective_mesh_file, *request.mesh_text);
  for (const auto& message : request.messages) note(message);
  for (const auto& warning : plan.warnings) note("warning: " + warning);
}

void RunOutputs::write_the_start() {
  write(solver_.record());
  write_points();
  write_grid();
}

double RunOutputs::next() const {
  return std::min({history_due_.next(), points_due_.next(), grid_due_.next(), checkpoint_due_.next()});
}

void RunOutputs::write_what_is_due(bool end) {
  const double time = solver_.time();
  if (history_due_.passed(time) || end) write(solver_.record());
  if (points_due_.passed(time) || end) write_points();
  if (grid_due_.passed(time) || end) write_grid();
}

bool RunOutputs::takes_checkpoint(bool end) {
  const bool last = end && plan_.scene.outputs.checkpoint > 0;
  return checkpoint_due_.passed(solver_.time()) || last;
}

void RunOutputs::warn(const std::string& text) {
  keep("warning: " + text);
  if (request_.warn) request_.warn(text);
}

void RunOutputs::keep(const std::string& line) {
  note(line);
  messages_.push_back(line);
}

void RunOutputs::save(Checkpoint& checkpoint) const {
  checkpoint.records = history_.records;
  for (const Due* due : {&history_due_, &points_due_, &grid_due_, &checkpoint_due_}) {
    checkpoint.dues.push_back(due->save());
  }
  checkpoint.point_snapshots = point_snapshots_, checkpoint.grid_snapshots = grid_snapshots_;
  checkpoint.messages = messages_;
}

void RunOutputs::restore(const Checkpoint& checkpoint) {
  for (const Record& record : checkpoint.records) write(record);
  for (const auto& message : checkpoint.messages) keep(message);
  const std::array dues{&history_due_, &points_due_, &grid_due_, &checkpoint_due_};
  for (std::size_t k = 0; k < dues.size(); ++k) dues[k]->restore(checkpoint.dues.at(k), checkpoint.time);
  if (checkpoint.written_by != this_program())
    warn(fmt::format("the checkpoint was written by {}: what follows may differ in last bits", checkpoint.written_by));
  note(fmt::format("goes on from {} at t = {:.6g}", request_.restart.string(), checkpoint.time));
  const Snapshot points = solver_.points();
  const std::string run = sha256(checkpoint.deck_effective);
  if (!points.fields.empty())
    take_over("particles.nc", {points, checkpoint.point_snapshots, run, points_change(plan_.scene)},
              [this](const Snapshot& snapshot) { write_points(snapshot); });
  take_over("mesh.nc", {solver_.grid(), checkpoint.grid_snapshots, run},
            [this](const Snapshot& snapshot) { write_grid(snapshot); });
  if (const Snapshot solids = solver_.solids(); !solids.fields.empty())
    take_over("solids.nc", {solids, checkpoint.grid_snapshots, run},
              [this](const Snapshot& snapshot) { folder_.solids(plan_.scene.solids()->mesh, snapshot); });
  if (const Snapshot surface = solver_.surface(); !surface.fields.empty())
    take_over("surface.nc", {surface, checkpoint.grid_snapshots, run, true},
              [this](const Snapshot& snapshot) { folder_.surface(snapshot); });
  if (const Snapshot flow = solver_.flow_cells(); !flow.fields.empty())
    take_over("flow.nc", {flow, checkpoint.grid_snapshots, run, true},
              [this](const Snapshot& snapshot) { folder_.flow(snapshot); });
}

/// From beside the checkpoint, else from the run's own folder.
void RunOutputs::take_over(const std::string& name, const WantedSnapshots& wanted,
                           const std::function<void(const Snapshot&)>& write_one) {
  std::size_t taken = 0;
  const auto take = [&](const Snapshot& snapshot) {
    write_one(snapshot);
    ++taken;
    const int signal = request_.interrupted ? request_.interrupted() : 0;
    if (signal != 0) throw Interrupted(signal, "interrupted before the run went on; the same command does it again");
  };
  std::string lost;
  for (const auto& folder : {folder_of(request_.restart), folder_.path()}) {
    if (taken == 0) lost = replay_snapshots(ResultFolder::earlier_snapshots(folder, name), wanted, take);
    if (lost.empty()) return folder_.remove_what_was_set_aside(name);
  }
  const auto kept = folder_.keep_what_was_set_aside(name);
  warn(kept.empty() ? lost : fmt::format("{}; what is there stays as {}", lost, kept.string()));
}

void RunOutputs::write(Record record) {
  history_.records.push_back(record);
  queue_.give([this, record = std::move(record)] { folder_.append(record); }, 0);
}

void RunOutputs::write_points() {
  solver_.write_points([this](const FieldsInTurn& fields) { write_points(fields); });
}

/// Field by field: the thread of its own writes those that are there while the next ones are made.
void RunOutputs::write_points(const FieldsInTurn& snapshot) {
  if (queue_.has_thread()) {
    const auto channel = channel_for(snapshot, most_waiting);
    queue_.give([this, fields = fields_from(channel, snapshot)] { folder_.points(fields); }, 0);
    put_fields(snapshot, *channel);
  } else {
    folder_.points(snapshot);
  }
  ++point_snapshots_;
}

void RunOutputs::write_grid() {
  if (plan_.scene.outputs.grid == 0) return;
  write_grid(solver_.grid());
  if (Snapshot solids = solver_.solids(); !solids.fields.empty()) {
    const std::size_t bytes = bytes_of(solids);
    queue_.give([this, solids = std::move(solids)] { folder_.solids(plan_.scene.solids()->mesh, solids); }, bytes);
  }
  if (Snapshot surface = solver_.surface(); !surface.fields.empty()) {
    const std::size_t bytes = bytes_of(surface);
    queue_.give([this, surface = std::move(surface)] { folder_.surface(surface); }, bytes);
  }
  if (Snapshot flow = solver_.flow_cells(); !flow.fields.empty()) {
    const std::size_t bytes = bytes_of(flow);
    queue_.give([this, flow = std::move(flow)] { folder_.flow(flow); }, bytes);
  }
}

void RunOutputs::write_grid(Snapshot snapshot) {
  const std::size_t bytes = bytes_of(snapshot);
  queue_.give(
      [this, snapshot = std::move(snapshot)] {
        const Scene& scene = plan_.scene;
        if (const Mesh* mesh = std::visit(MeshOfGrid{}, scene.physics))
          folder_.mesh(*mesh, snapshot);
        else
          folder_.grid(scene.coupled() ? RegularGrid(scene.coupled()->grid) : scene.grid, snapshot);
      },
      bytes);
  ++grid_snapshots_;
}

}  // namespace tether
