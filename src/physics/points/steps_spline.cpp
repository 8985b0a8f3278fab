// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/steps_of_scheme.hpp"

namespace tether::mpm {

StepSet spline_step_set(const Scene& scene) { return step_set_of_kernel<SplineKernel>(scene); }

}  // namespace tether::mpm
