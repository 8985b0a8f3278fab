// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/steps.hpp"

namespace tether::mpm {

StepSet step_set(const Scene& scene) {
  return scene.method.kernel == Kernel::linear ? linear_step_set(scene) : spline_step_set(scene);
}

}  // namespace tether::mpm
