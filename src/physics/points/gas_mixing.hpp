// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "model/scene.hpp"
#include "physics/points/state.hpp"

namespace tether::mpm {

/// Looks at gases whose density is that of their cell, (4.5), (4.6), and at cells that two bodies of them share. There
/// each has the density of both together: the pressures (gamma - 1) rho i of gases that press on one another alike come
/// out as different as their energies i. The forces, from which the density cancels, know nothing of it.
class GasMixing {
 public:
  GasMixing(const Scene& scene, const Frame& frame);

  bool on() const { return on_; }
  /// Looks at the present places, and adds to `messages` what there is to warn of, once a run.
  void look(State& state, const Scene& scene, std::vector<std::string>& messages);

 private:
  /// Values of (gamma - 1) i, from the least to the most; none where `most` is 0.
  struct Span {
    double least = 0, most = 0;
    void add(const Span& other);
    /// Returns how far apart the two lie, as a ratio.
    double ratio(const Span& other) const;
  };
  struct Cell {
    double mass = 0, energy = 0;  // of the body in hand: mass, and (gamma - 1) i times mass
    Span here, before;            // of what the body in hand gives to its density, and of the bodies before it
    bool holds = false;           // points of gas
  };
  struct Worst {
    double ratio = 1;
    std::size_t cell = 0;
  };

  void add_body(const Points& points, Slots range, double gm1);
  void spread(std::size_t cell);
  void compare_with_earlier();

  Locator locator_;
  bool on_ = false;
  std::size_t columns_ = 0;
  int reach_ = 0;  // of a body's density, beyond the cells that it is in [cells]
  std::vector<Cell> cells_;
  std::vector<std::size_t> held_, reached_;  // the cells of the body in hand, and those that it gives density to
  Worst worst_;
};

}  // namespace tether::mpm
