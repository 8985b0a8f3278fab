// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algebra/sparse_matrix.hpp"
#include "model/flow.hpp"

namespace tether::fem {

/// The clusters of unknowns that elements couple, for ClusterPattern: the nodes of each, twins as one.
Lists clusters_of(const Flow& flow);

}  // namespace tether::fem
