// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "model/coupled.hpp"
#include "physics/box/liquid/sums.hpp"
#include "physics/box/state.hpp"
#include "physics/solids/fields.hpp"

namespace tether::coupled {

struct CoupledSetting : fem::MeshSetting {
  bool with_solids = false, with_smoke = false, with_liquid = false;
  std::vector<double> first_volumes;  ///< that the surface's sheets enclose at the start, negative of cavities [volume]
};

/// What a record of a box is made from.
struct CoupledSums : fem::MeshSums {
  const CoupledState& state;
  double fluid = 0;         ///< kinetic energy of the fluid [energy]
  double fluid_volume = 0;  ///< [volume]
  double pressure_energy = 0;
  double regions = 0;  ///< of the fluid
  double smoke_mass = 0, smoke_largest = 0;
  liquid::LiquidSums liquid = {};
  std::vector<double> sheets = {};  ///< volumes that the surface's sheets enclose [volume]
  std::vector<Components> force = {},
                          hold = {};  ///< on each body: of the fluid; of supports, walls and obstacles [force]
};

/// All columns that the history of a box may have.
const ColumnTable<CoupledSetting, CoupledSums>& coupled_table();

}  // namespace tether::coupled
