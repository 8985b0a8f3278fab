// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "physics/solids/make_elements.hpp"
#include "unit/alone.hpp"
#include "unit/physics/solids/blocks_support.hpp"

namespace tether::fem {
namespace {

using namespace support;

constexpr StressAt all_rules[] = {StressAt::gradient, StressAt::middle, StressAt::end};

/// The stresses between two shapes, changed as a change of the second one predicts.
struct Predicted {
  const Elements& elements;
  StressAt rule;
  const std::vector<double>& q0;

  std::vector<double> operator()(const std::vector<double>& q1, const std::vector<double>& change) const {
    std::vector<double> stresses;
    elements.predict_stress(rule, q0, q1, change, stresses);
    return stresses;
  }
};

std::vector<double> moved(std::vector<double> q, double h, const std::vector<double>& by) {
  for (std::size_t k = 0; k < q.size(); ++k) q[k] += h * by[k];
  return q;
}

/// What a change of places predicts against central differences of the stresses themselves.
TEST(PredictedStress, IsTheStressAndItsDerivative) {
  constexpr double h = 1e-6;
  for (const Element& element : all_elements()) {
    for (const ElasticLaw& law : {neo_hookean(), ElasticLaw(LinearElastic{{2, 1.3}})}) {
      const Solids solids = skew_block(element, law, {1, 1, 1});
      const auto elements = make_elements(solids, alone());
      const std::vector<double> q0 = shaken(solids.mesh, 1, 0.04), q1 = shaken(solids.mesh, 2, 0.04);
      const std::vector<double> by = moved(shaken(solids.mesh, 3, 1), -1, solids.mesh.x), none(by.size(), 0.0);
      for (const StressAt rule : all_rules) {
        const Predicted predicted{*elements, rule, q0};
        const std::vector<double> now = predicted(q1, none), then = predicted(q1, by);
        const std::vector<double> above = predicted(moved(q1, h, by), none), below = predicted(moved(q1, -h, by), none);
        double largest = 0, worst = 0;
        for (std::size_t k = 0; k < now.size(); ++k) {
          const double slope = (above[k] - below[k]) / (2 * h);
          largest = std::max(largest, std::abs(slope));
          worst = std::max(worst, std::abs(then[k] - now[k] - slope));
        }
        EXPECT_GT(largest, 0);
        EXPECT_LT(worst, 1e-6 * largest) << element << " " << law.index() << " " << static_cast<int>(rule);
      }
    }
  }
}

/// A tangent that takes the stresses that there are is the plain one; it changes with them.
TEST(PredictedStress, StandsForTheStressInATangent) {
  for (const Element& element : all_elements()) {
    const Solids solids = skew_block(element, neo_hookean(), {1, 1, 1});
    const auto elements = make_elements(solids, alone());
    const std::vector<double> q0 = shaken(solids.mesh, 1, 0.04), q1 = shaken(solids.mesh, 2, 0.04);
    const NodalPattern pattern(solids.mesh.dim(), solids.mesh.node_count(), solids.mesh.nodes,
                               node_count_of(element.kind));
    std::vector<double> stresses = Predicted{*elements, StressAt::middle, q0}(q1, std::vector<double>(q1.size(), 0.0));
    const auto tangent = [&](std::span<const double> with) {
      SparseMatrix K = pattern.matrix();
      elements->add_tangent(StressAt::middle, q0, q1, 0, pattern, K, with);
      return K.value;
    };
    EXPECT_EQ(tangent(stresses), tangent({})) << element;
    for (double& stress : stresses) stress *= 2;
    EXPECT_NE(tangent(stresses), tangent({})) << element;
  }
}

}  // namespace
}  // namespace tether::fem
