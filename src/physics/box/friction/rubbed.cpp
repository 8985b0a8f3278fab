// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/friction/rubbed.hpp"

#include <fmt/format.h>

#include "base/diagnostics.hpp"

namespace tether::coupled {

void Rubbed::book(double h, CoupledState& state, std::span<double> drag) const {
  if (iterations < 0)
    throw RunError(
        fmt::format("t = {:.9g}: conjugate gradients do not converge for the fluid's friction: likely cause, "
                    "values that ran away",
                    state.time),
        Failure::does_not_converge);
  for (std::size_t k = 0; k < impulse.size(); ++k) drag[k] = impulse[k] / h;
  state.books.viscous += heat;
  state.books.projected += taken - heat;
}

}  // namespace tether::coupled
