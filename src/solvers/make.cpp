// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/make.hpp"

#include "solvers/mpm/solver.hpp"
#include "solvers/mpm/steps.hpp"

namespace tether {

std::unique_ptr<Solver> make_solver(const Plan& plan) {
  switch (plan.scene.order) {
    case StressOrder::usf:
      return std::make_unique<mpm::MpmSolver<mpm::Usf>>(plan);
    case StressOrder::usl:
      return std::make_unique<mpm::MpmSolver<mpm::Usl>>(plan);
    case StressOrder::musl:
      break;
  }
  return std::make_unique<mpm::MpmSolver<mpm::Musl>>(plan);
}

}  // namespace tether
