// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "model/scene.hpp"
#include "solvers/mpm/state.hpp"

namespace tether::mpm {

/// Looks how far apart the points of solids that carry F have been stretched.
class StretchWatch {
 public:
  explicit StretchWatch(const Scene& scene) : on_(find_body<FiniteElastic>(scene) != nullptr) {}

  bool on() const { return on_; }
  /// Looks at the present F, and adds to `messages` a warning of points that stand too far apart, once a run.
  void look(State& state, const Scene& scene, std::vector<std::string>& messages) const;

 private:
  bool on_ = false;
};

}  // namespace tether::mpm
