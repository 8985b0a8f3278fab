// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/column_guide.hpp"

#include "solvers/coupled/coupled_columns.hpp"
#include "solvers/fem/bar_fields.hpp"
#include "solvers/fem/flow_columns.hpp"
#include "solvers/fem/rigid_fields.hpp"
#include "solvers/fem/solid_fields.hpp"
#include "solvers/mpm/fields.hpp"

namespace tether {

std::vector<PhysicsColumns> columns_of_all_physics() {
  return {{"points", mpm::history_table().described()}, {"bars", fem::bar_table().described()},
          {"bodies", fem::solid_table().described()},   {"rigid body", fem::rigid_table().described()},
          {"flows", fem::flow_table().described()},     {"boxes", coupled::coupled_table().described()}};
}

}  // namespace tether
