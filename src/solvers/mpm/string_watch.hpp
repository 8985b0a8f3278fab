// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "model/scene.hpp"
#include "model/string_gaps.hpp"
#include "solvers/mpm/state.hpp"

namespace tether::mpm {

/// Looks whether the strings and membranes still hold together and to their walls, and how far apart neighbours are.
class StringWatch {
 public:
  explicit StringWatch(const Scene& scene);

  bool on() const { return on_; }
  /// Looks at the present places, and adds to `messages` what there is to warn of, each once a run: neighbours of which
  /// neither feels the other, or between which fluid passes; an end that has come off its wall.
  void look(State& state, const Scene& scene, std::vector<std::string>& messages) const;

 private:
  /// An end that begins at a wall and is to stay there.
  struct End {
    std::size_t body = 0, point = 0;  // the point in the body
    StringEnd at;
  };

  void look_at_ends(State& state, const Scene& scene, std::vector<std::string>& messages) const;

  bool on_ = false;  // whether there are any strings
  std::vector<End> ends_;
};

}  // namespace tether::mpm
