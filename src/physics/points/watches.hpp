// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "model/scene.hpp"
#include "model/string_gaps.hpp"
#include "physics/points/state.hpp"

namespace tether::mpm {

/// Looks whether gas has passed through membranes that part the grid: closed ones, and those whose two ends begin at
/// edges of the grid. A point that is on the other side than at the start, half a cell deep, has passed.
class LeakWatch {
 public:
  LeakWatch(const Scene& scene, const State& state);

  bool on() const { return !walls_.empty(); }
  /// Counts at the present places, and adds to `messages` what there is to warn of, once a run.
  void look(State& state, const Scene& scene, std::vector<std::string>& messages) const;

 private:
  using Corners = std::vector<Vec<2>>;
  /// A membrane that parts the grid.
  struct Parting {
    std::size_t body = 0;
    int first_side = -1, last_side = -1;  // of the grid, at which its ends are; none of a closed one
    std::vector<std::uint8_t> inside;     // at the start, of each point of the scene
  };

  static Corners closed(const Parting& parting, const BackgroundGrid& grid, Corners points);
  std::size_t passed(const Parting& parting, const State& state, const Scene& scene) const;

  std::vector<Parting> walls_;
  double deep_ = 0;  // [length]
};

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

/// Looks whether the strings and membranes still hold together and to their walls, and how far apart neighbours are.
class StringWatch {
 public:
  StringWatch(const Scene& scene, const State& state);

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
