// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "fields/fields_in_turn.hpp"
#include "grid/mesh.hpp"
#include "results/grid_writer.hpp"
#include "results/history_writer.hpp"
#include "results/mesh_writer.hpp"
#include "results/point_writer.hpp"
#include "results/results.hpp"
#include "results/text_file.hpp"

namespace tether {

/// What becomes of the snapshots that an earlier run left: removed, or set aside until a run that goes on from a
/// checkpoint has taken over what is its own.
enum class EarlierSnapshots { removed, set_aside };

/// How a run's folder is used.
struct FolderUse {
  VtkFiles vtk = VtkFiles::automatic;
  EarlierSnapshots earlier = EarlierSnapshots::removed;
  bool points_change = false;  ///< whether their number does
  int dim = 2;                 ///< of the space of a surface and of a flow
};

/// The folder of one run's outputs, as the contract lists them. Everything handed over is with the system before the
/// call returns, so that a crash or a full disk loses nothing that was reported before. All members throw FileError.
class ResultFolder {
 public:
  /// Creates the folder and those above it, and removes what an earlier run left there under the names that belong to
  /// this class; checkpoints and other files stay.
  ResultFolder(const std::filesystem::path& folder, const HistoryLayout& layout, const Provenance& provenance,
               const FolderUse& use = {});
  /// Returns where the snapshots of an earlier run stand, those of particles.nc, mesh.nc, solids.nc,
  /// surface.nc or flow.nc: set aside or not.
  static std::filesystem::path earlier_snapshots(const std::filesystem::path& folder, const std::string& name);
  /// Ends the setting aside of one of these.
  void remove_what_was_set_aside(const std::string& name);
  /// Does the same for what could not be taken over: it stays as NAME.unused, which is returned; empty where there is
  /// none.
  std::filesystem::path keep_what_was_set_aside(const std::string& name);

  void append(const Record& record);                             ///< history.nc and history.txt
  void points(const FieldsInTurn& snapshot);                     ///< particles.nc
  void grid(const RegularGrid& grid, const Snapshot& snapshot);  ///< mesh.nc
  void mesh(const Mesh& mesh, const Snapshot& snapshot);         ///< the same, of finite elements
  void solids(const Mesh& mesh, const Snapshot& snapshot);       ///< solids.nc, beside mesh.nc
  void surface(const Snapshot& snapshot);                        ///< surface.nc, with each mesh.nc record
  void flow(const Snapshot& snapshot);                           ///< flow.nc, likewise
  void message(const std::string& text);         ///< messages.txt; a line end is added where it has none
  void deck_effective(const std::string& text);  ///< deck.effective
  /// A file that deck.effective names, under a name that begins with its.
  void beside_deck(const std::string& name, const std::string& text);
  void reference(const Table& table);  ///< reference.txt
  /// Closes all files, then writes summary.txt: where it stands, the run came to its end. Nothing may follow.
  void finish(const Summary& summary);

  const std::filesystem::path& path() const { return folder_; }

 private:
  std::filesystem::path folder_;
  std::string command_;
  HistoryWriter history_;
  PointWriter points_;
  GridWriter grid_;
  MeshWriter mesh_, solids_;
  PointWriter surface_, flow_;
  TextFile messages_;
};

}  // namespace tether
