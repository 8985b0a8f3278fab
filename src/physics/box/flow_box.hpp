// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "grid/crossings.hpp"
#include "model/coupled.hpp"
#include "physics/box/closed_regions.hpp"
#include "physics/box/cut_cells.hpp"
#include "physics/box/outside.hpp"
#include "physics/box/smoke.hpp"

namespace tether::coupled {

/// Returns whether a place of a side lies in a patch of it, not at the patch's edge.
bool lies_in(const Box<3>& patch, int side, const Vec<3>& x, int dim);
/// Returns the last jet that has a place of a side; -1: none.
int jet_at(const Coupled& scene, int side, const Vec<3>& x);
/// The mean speeds of jets in a step of length h, into the box [velocity].
std::vector<double> jet_speeds(const Coupled& scene, double time, double h);

/// The box without solids: obstacles, voids, walls, jets and open sides.
class FlowBox {
 public:
  explicit FlowBox(const Coupled& scene);

  /// The domain that solids leave: cells whose middle lies in one hold no fluid, faces between whose cells' middles a
  /// surface passes are closed. Where the scene wants fluid in cavities alone, the rest is void.
  FlowDomain around(const Crossings& crossings) const;
  /// Returns the same with the open parts of faces: cells whose middle lies in a solid hold fluid where a face of
  /// theirs is open.
  FlowDomain around(const Crossings& crossings, const CutCells& cut) const;
  /// Sets the velocities of prescribed faces in a step of length h: jets have their mean speeds [velocity].
  void prescribe(const FlowDomain& domain, double time, double h, FaceValues& v) const;
  /// Returns what jets bring in through the faces that they have in a step, by their shares of what comes in there.
  std::vector<SmokeJet> smoke_of_jets(double time, double h) const;

 private:
  FlowDomain without_regions(const Crossings& crossings) const;
  void open_faces(const Crossings& crossings, FlowDomain& domain) const;
  void fill_cut_cells(const CutCells& cut, FlowDomain& domain) const;
  void open_cut_cells(const Crossings& crossings, const CutCells& cut, FlowDomain& domain) const;
  /// How much of a face is open: less than 1 of faces in the box's sides alone.
  double open_part(int axis, std::size_t face, FaceKind kind) const;
  FaceKind kind_between(const FlowDomain& domain, int axis, std::size_t face) const;
  FaceKind kind_at_side(int axis, std::size_t face, CellKind cell) const;

  const Coupled& scene_;
  std::vector<CellKind> kind_;
  std::shared_ptr<const SideFaces> side_faces_;
};

/// Numbers the parts of the fluid that open faces join.
void find_regions(FlowDomain& domain);
/// Takes the fluid out of the marked regions, and numbers the others anew.
void drop_regions(std::span<const std::uint8_t> regions, FlowDomain& domain);

}  // namespace tether::coupled
