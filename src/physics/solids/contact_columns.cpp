// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solids/fields.hpp"

namespace tether::fem {

ColumnGroup<SolidSetting, SolidSums> contact_columns() {
  using Row = Column<SolidSetting, SolidSums>;
  static const When<SolidSetting> meets("with contact", [](const SolidSetting& s) { return s.meets; });
  const auto row = [](const char* name, Dimension dimension, const char* meaning, double ContactState::*value) {
    return Row(name, dimension, meaning, [value](const SolidSums& s) { return s.contact.*value; }).when(meets);
  };
  return {{row("energy_contact", Dimension::energy, "energy stored between surfaces that press each other",
               &ContactState::energy),
           row("energy_friction", Dimension::energy, "energy that friction between surfaces has taken",
               &ContactState::rubbed)
               .booked(Book::given),
           row("energy_contact_damped", Dimension::energy, "energy that contact has taken where it is damped",
               &ContactState::damped)
               .booked(Book::given),
           row("contact_force", Dimension::force, "sum of the sizes of the forces across surfaces in the last step",
               &ContactState::pressing),
           row("contact_gap", Dimension::length, "least distance of surfaces that press each other; 0 where none do",
               &ContactState::least_gap),
           row("contact_sides", Dimension::number, "sides of bodies that are nearer to another surface than the gap",
               &ContactState::sides)}};
}

}  // namespace tether::fem
