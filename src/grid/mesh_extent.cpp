// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/mesh_extent.hpp"

#include <algorithm>

namespace tether {

MeshExtent::MeshExtent(const Mesh& mesh) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  for (std::size_t i = 0; i < dim && !mesh.x.empty(); ++i) {
    low[i] = high[i] = mesh.x[i];
    for (std::size_t n = i; n < mesh.x.size(); n += dim)
      low[i] = std::min(low[i], mesh.x[n]), high[i] = std::max(high[i], mesh.x[n]);
  }
}

double MeshExtent::size() const { return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]}); }

}  // namespace tether
