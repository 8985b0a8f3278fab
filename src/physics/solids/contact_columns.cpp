// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solids/fields.hpp"

namespace tether::fem {

ColumnGroup<MeshSetting, MeshSums> contact_columns() {
  using Row = Column<MeshSetting, MeshSums>;
  using Numbers = contact::ContactNumbers;
  static const When<MeshSetting> meets("with contact", [](const MeshSetting& s) { return s.meets; });
  const auto last = [](const char* name, Dimension dimension, const char* meaning, double Numbers::*value) {
    return Row(name, dimension, meaning, [value](const MeshSums& s) { return s.contact.last.*value; }).when(meets);
  };
  const auto taken = [](const char* name, const char* meaning, double ContactState::*value) {
    return Row(name, Dimension::energy, meaning, [value](const MeshSums& s) { return s.contact.*value; })
        .when(meets)
        .booked(Book::given);
  };
  return {
      {last("energy_contact", Dimension::energy, "energy stored between surfaces that press each other",
            &Numbers::energy),
       taken("energy_friction", "energy that friction between surfaces has taken", &ContactState::rubbed),
       taken("energy_contact_damped",
             "energy that contact has taken where it is damped, and in steps of backward Euler", &ContactState::damped),
       last("contact_force", Dimension::force, "sum of the sizes of the forces across surfaces in the last step",
            &Numbers::pressing),
       last("contact_gap", Dimension::length, "least distance of surfaces that press each other; 0 where none do",
            &Numbers::least_gap),
       last("contact_sides", Dimension::number, "sides of bodies that are nearer to another surface than the gap",
            &Numbers::sides)}};
}

}  // namespace tether::fem
