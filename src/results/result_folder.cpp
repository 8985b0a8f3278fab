// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/result_folder.hpp"

#include <fmt/format.h>
#include <array>
#include <system_error>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "base/process.hpp"
#include "results/text_file.hpp"

namespace tether {
namespace {

constexpr std::array owned{
    "history.nc",         "history.txt",       "particles.nc",  "particles.pvd",  "mesh.nc",      "mesh.pvd",
    "solids.nc",          "solids.pvd",        "reference.txt", "summary.txt",    "messages.txt", "deck.effective",
    "deck.effective.msh", "particles.pvd.new", "mesh.pvd.new",  "solids.pvd.new", "surface.nc",   "surface.pvd",
    "surface.pvd.new",    "flow.nc",           "flow.pvd",      "flow.pvd.new"};

constexpr std::array snapshot_files{"particles.nc", "mesh.nc", "solids.nc", "surface.nc", "flow.nc"};

std::filesystem::path aside(const std::filesystem::path& folder, const std::string& name) {
  return folder / (name + ".earlier");
}

void remove_earlier(const std::filesystem::path& path) {
  std::error_code reason;
  std::filesystem::remove(path, reason);
  if (reason) {
    throw FileError(fmt::format("{}: an earlier run's file cannot be removed: {}", path.string(), reason.message()));
  }
}

/// Snapshots that stand aside already are whole, and those beside them the part that a restart cut short took over.
void set_aside(const std::filesystem::path& folder) {
  for (const char* name : snapshot_files) {
    const bool there = std::filesystem::exists(folder / name), already = std::filesystem::exists(aside(folder, name));
    if (there && !already) put_in_place(folder / name, aside(folder, name));
  }
}

/// Those of the series that belong to this class; the folder goes where nothing else is in it.
void remove_vtk_files(const std::filesystem::path& folder) {
  std::error_code reason;
  const std::filesystem::directory_iterator files(folder / vtk_folder, reason);
  if (reason) return;  // there is none
  for (const auto& file : files) {
    const std::string name = file.path().filename().string();
    for (const char* series : {"particles-", "mesh-", "solids-", "surface-", "flow-"}) {
      if (name.starts_with(series)) remove_earlier(file.path());
    }
  }
  std::filesystem::remove(folder / vtk_folder, reason);
}

std::filesystem::path prepared(const std::filesystem::path& folder, EarlierSnapshots earlier) {
  std::error_code reason;
  std::filesystem::create_directories(folder, reason);
  if (reason) throw FileError(fmt::format("{}: the folder cannot be made: {}", folder.string(), reason.message()));
  if (earlier == EarlierSnapshots::set_aside) set_aside(folder);
  for (const char* name : owned) remove_earlier(folder / name);
  remove_vtk_files(folder);
  for (const char* name : snapshot_files) {
    if (earlier == EarlierSnapshots::removed) remove_earlier(aside(folder, name));
  }
  return folder;
}

}  // namespace

ResultFolder::ResultFolder(const std::filesystem::path& folder, const HistoryLayout& layout,
                           const Provenance& provenance, const FolderUse& use)
    : folder_(prepared(folder, use.earlier)),
      command_(provenance.command),
      history_(folder_, layout, provenance),
      points_(folder_, provenance, use.vtk, use.points_change),
      grid_(folder_, provenance, use.vtk),
      mesh_(folder_, "mesh", provenance, use.vtk),
      solids_(folder_, "solids", provenance, use.vtk),
      surface_(folder_, provenance, use.vtk, true, use.dim == 2 ? edges_file : triangles_file),
      flow_(folder_, provenance, use.vtk, true, use.dim == 2 ? flow_triangles_file : flow_tetrahedra_file),
      messages_(folder_ / "messages.txt") {}

std::filesystem::path ResultFolder::earlier_snapshots(const std::filesystem::path& folder, const std::string& name) {
  return std::filesystem::exists(aside(folder, name)) ? aside(folder, name) : folder / name;
}

void ResultFolder::remove_what_was_set_aside(const std::string& name) { remove_earlier(aside(folder_, name)); }

std::filesystem::path ResultFolder::keep_what_was_set_aside(const std::string& name) {
  if (!std::filesystem::exists(aside(folder_, name))) return {};
  auto unused = folder_ / (name + ".unused");
  put_in_place(aside(folder_, name), unused);
  return unused;
}

void ResultFolder::append(const Record& record) { history_.append(record); }

void ResultFolder::points(const FieldsInTurn& snapshot) { points_.append(snapshot); }

void ResultFolder::grid(const RegularGrid& grid, const Snapshot& snapshot) { grid_.append(grid, snapshot); }

void ResultFolder::mesh(const Mesh& mesh, const Snapshot& snapshot) { mesh_.append(mesh, snapshot); }

void ResultFolder::solids(const Mesh& mesh, const Snapshot& snapshot) { solids_.append(mesh, snapshot); }

void ResultFolder::surface(const Snapshot& snapshot) { surface_.append(snapshot); }

void ResultFolder::flow(const Snapshot& snapshot) { flow_.append(snapshot); }

void ResultFolder::message(const std::string& text) {
  const bool ended = !text.empty() && text.back() == '\n';
  messages_.append(ended ? text : text + '\n');
}

void ResultFolder::deck_effective(const std::string& text) { write_file(folder_ / "deck.effective", text); }

void ResultFolder::beside_deck(const std::string& name, const std::string& text) { write_file(folder_ / name, text); }

void ResultFolder::reference(const Table& table) { write_table(folder_ / "reference.txt", table); }

void ResultFolder::finish(const Summary& summary) {
  history_.close();
  points_.close();
  grid_.close();
  mesh_.close();
  solids_.close();
  surface_.close();
  flow_.close();
  write_summary(folder_ / "summary.txt", summary,
                {fmt::format("tether {} {}", program_version(), git_hash()), command_});
}

}  // namespace tether
