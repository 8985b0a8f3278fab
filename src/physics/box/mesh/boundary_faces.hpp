// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <map>

#include "physics/box/mesh/flow_mesh.hpp"

namespace tether::coupled {

/// The faces at a mesh's boundary by their nodes, for a mesher to set what they lie on.
class BoundaryFaces {
 public:
  /// Nodes of a face in any order; the third one is -1 in the plane.
  using Nodes = std::array<int, 3>;

  /// The mesh must outlive it.
  explicit BoundaryFaces(FlowMesh& mesh) : mesh_(mesh) {
    for (std::size_t f = 0; f < mesh.faces(); ++f) {
      if (!mesh.is_at_boundary(f)) continue;
      Nodes nodes{-1, -1, -1};
      std::ranges::copy(mesh.face_nodes(f), nodes.begin());
      face_of_[sorted(nodes)] = f;
    }
  }

  /// Sets what the face with these nodes lies on, where there is one.
  void set(const Nodes& nodes, const Boundary& boundary) {
    const auto found = face_of_.find(sorted(nodes));
    if (found != face_of_.end()) mesh_.boundary[found->second] = boundary;
  }
  /// Calls f(face) for each face that nothing was set for.
  template <class Function>
  void each_left(const Function& f) const {
    for (const auto& [nodes, face] : face_of_) {
      if (mesh_.boundary[face].kind == BoundaryKind::none) f(face);
    }
  }
  /// Closes these.
  void close_left() {
    each_left([&](std::size_t face) { mesh_.boundary[face].kind = BoundaryKind::closed; });
  }

 private:
  static Nodes sorted(Nodes nodes) {
    std::sort(nodes.begin(), nodes.end());
    return nodes;
  }

  FlowMesh& mesh_;
  std::map<Nodes, std::size_t> face_of_;
};

}  // namespace tether::coupled
