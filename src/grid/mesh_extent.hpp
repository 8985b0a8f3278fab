// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/vec.hpp"
#include "grid/mesh.hpp"

namespace tether {

/// The box around a mesh's nodes; zero in z in the plane, and zero without nodes [length].
struct MeshExtent {
  explicit MeshExtent(const Mesh& mesh);
  /// Returns the longest side: what the mesh's size is taken for.
  double size() const;

  Vec<3> low{}, high{};
};

}  // namespace tether
