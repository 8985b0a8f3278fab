// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deck/deck.hpp"
#include "model/scene.hpp"
#include "studies/automatic/resolution.hpp"

namespace tether::automatic {

/// A value of a deck that counts cells, nodes or points, or is a length of cells or of a step.
struct Refined {
  std::string element;  ///< "in.nx", "mesh.cells(2,1)"
  enum class As { cells, nodes, length, time } as = As::cells;
  double own = 0;  ///< the deck's value
  int least = 1;   ///< of cells; fewer of them, as many as the deck has
};

/// How a model is solved: the way of the deck, or by the finite elements of its bodies alone.
enum class Way { own, elements };

/// What makes a deck finer: the values that count its cells, and those that are its steps.
class Refinement {
 public:
  /// `scene` is the deck's. What cannot be made finer (points of a file, a mesh of a file) is not among the values.
  Refinement(const Deck& deck, const Scene& scene);

  bool in_space() const { return !space_.empty(); }
  bool in_time() const { return !time_.empty(); }
  /// Returns whether there are elements that can be made finer.
  bool has_elements() const { return !elements_.empty(); }
  /// The values that a run of that resolution has in place of the deck's: group.name=value. `stretch`: all steps are so
  /// much longer, those that the speed of sound limits, too.
  std::vector<std::string> overrides(const Resolution& wanted, Way way, double stretch = 1) const;
  /// The resolution that these values come to, since counts are whole numbers: the mean of their factors.
  Resolution rounded(const Resolution& wanted, Way way) const;
  /// Returns whether bodies and the cells that are refined are not made to fit.
  bool is_of_a_grid() const { return of_a_grid_; }
  /// Returns how much finer than the deck's a step is.
  double fineness(double step) const;
  /// In how many directions cells grow more where space is refined.
  int dimensions() const { return dimensions_; }

 private:
  void add_grid(const Deck& deck, const Scene& scene);
  void add_elements(const Deck& deck, bool are_of_own_way);
  const std::vector<Refined>& space(Way way) const { return way == Way::own ? space_ : elements_; }
  void add_strings(const Deck& deck);
  void add_steps(const Deck& deck);

  std::vector<Refined> space_, elements_, time_;
  std::optional<Refined> limit_;  // of the steps, over what sound takes through a cell
  int dimensions_ = 1;
  bool of_a_grid_ = false;
};

/// Orders that theory gives the errors of a scene, solved that way; none for what `refinement` does not refine.
Orders theory_of(const Deck& deck, const Scene& scene, const Refinement& refinement, Way way);

}  // namespace tether::automatic
