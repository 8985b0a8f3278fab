// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/steps_of_scheme.hpp"

namespace tether::mpm {

StepSet linear_step_set(const Scene& scene) { return step_set_of_kernel<LinearKernel>(scene); }

}  // namespace tether::mpm
