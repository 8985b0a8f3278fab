// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "base/vec.hpp"
#include "base/words.hpp"
#include "grid/contact/surface_plane.hpp"

namespace tether {

/// How contact enters a step: by a discrete gradient that gives back all the energy that it takes, by forces of the
/// step's end that let no more out than went in, or as the scene asks: damped where there is friction.
enum class ContactStep { automatic, energy, damped };
template <>
inline constexpr std::array<Word<ContactStep>, 3> words<ContactStep>{
    {{ContactStep::automatic, "auto"}, {ContactStep::energy, "energy"}, {ContactStep::damped, "damped"}}};

/// That the scene's bodies stop each other, themselves, and at walls, as the deck's group $contact says.
struct Contact {
  double gap = 0;        ///< at which sides begin to press each other [length]
  double stiffness = 0;  ///< of the pressure between them [stress]; 0: found from the bodies' laws
  double friction = 0;   ///< Coulomb's coefficient
  double stick = 0;      ///< speed below which friction is in proportion to it [velocity]; 0: found from the scene
  ContactStep step = ContactStep::automatic;
  int parts = 1;                     ///< of a line of a side, each with points of quadrature of its own
  bool bodies = true;                ///< whether bodies meet each other
  bool itself = true;                ///< whether a body meets itself
  std::vector<int> nodes;            ///< of the sides and regions that can meet something, ascending; empty: all can
  std::vector<SurfacePlane> planes;  ///< walls of the box, slopes: nothing goes beyond
  std::vector<Box<3>> obstacles;
};

/// Returns whether contact takes energy out of a step.
inline bool is_damped(const Contact& contact) {
  return contact.step == ContactStep::damped || (contact.step == ContactStep::automatic && contact.friction > 0);
}

}  // namespace tether
