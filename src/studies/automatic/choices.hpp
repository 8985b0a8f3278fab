// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "deck/deck.hpp"
#include "model/scene.hpp"
#include "studies/automatic/outlook.hpp"
#include "studies/automatic/refinement.hpp"

namespace tether::automatic {

/// What the model of a run leaves out.
struct LeftOut {
  std::vector<std::string> overrides = {};  ///< group.name=value
  Way way = Way::own;                       ///< how the rest is solved
};

/// A part of the model that a run may do without, or a cheaper one in its place.
struct Choice {
  std::string name;  ///< what is left out: "viscosity"
  LeftOut without;   ///< the run without it
};

/// Returns what a deck models that a run may do without, where its path has another way: of points contact, viscosity
/// and the pressure outside; of elastic bodies their deformation, or large strains; of a fluid in a box viscosity,
/// contact with walls, the simultaneous solution and steps that keep the energy, or the fluid as a whole; and ways to
/// solve that are cheaper: elements, cells, paths.
std::vector<Choice> choices_of(const Deck& deck, const Scene& scene, const Refinement& refinement);

/// What became of one.
struct Decision {
  Choice choice;
  bool left_out = false;
  double change = 0;  ///< of the number without it, over the number; not a number where the run failed
  std::string why;    ///< why it stays; empty where it is left out
};

/// Decides by a pair of runs, with it and without: what changes the number by less than a third of the tolerance is
/// left out where the run costs no more without it.
Decision decided(const Choice& choice, const Trial& with, const Trial& without, double tolerance);

/// The most that what is left out may change the number by, over it, where that is to be within the tolerance.
constexpr double most_change(double tolerance) { return tolerance / 3; }

/// A line for each, for people.
std::string decisions_text(const std::vector<Decision>& decisions);

}  // namespace tether::automatic
