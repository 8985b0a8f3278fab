// SPDX-License-Identifier: GPL-3.0-or-later
// A solver that takes up a saved state goes on as the one that saved it, to the last bit, whatever the method's parts.
#include <gtest/gtest.h>

#include <functional>

#include "unit/physics/points/robust_support.hpp"

namespace tether::mpm {
namespace {

using namespace scenes;

struct Saved {
  const char* name;
  std::function<void(Method&)> change;  // of the robust set
  Geometry geometry = Geometry::plane;
};
void PrintTo(const Saved& one, std::ostream* out) { *out << one.name; }

void thesis(Method& method) {
  method = Method{};
  method.contact = ContactRule::release;
}

const Saved methods[] = {
    {"Robust", [](Method&) {}},
    {"RobustAboutAnAxis", [](Method&) {}, Geometry::axisymmetric},
    {"RobustFlip", [](Method& m) { m.transfer = Transfer::flip, m.ledger = false; }},
    {"RobustWithCriterion3",
     [](Method& m) { m.contact = ContactRule::release, m.criterion = 3, m.ledger = false, m.jaumann = true; }},
    {"Thesis", thesis},
    {"ThesisAboutAnAxis", thesis, Geometry::axisymmetric},
    {"ThesisWithElements", [](Method& m) { thesis(m), m.membrane_strain = MembraneStrain::element, m.criterion = 3; }},
    {"ThesisWithNormals",
     [](Method& m) { thesis(m), m.normals = NormalRule::mass_linear, m.lone_point = LonePoint::previous; }},
    {"SplinesByMusl", [](Method& m) { m = Method{}, m.kernel = Kernel::bspline, m.transfer = Transfer::apic; }},
};

/// All there is: a bag of gas under pressure from outside, a pinned string, and a solid that meets the bag.
Scene everything(const Saved& saved) {
  Scene scene =
      scene_on(BackgroundGrid(19, 21, 0, 3.6, -2, 2), {Wall::symmetry, Wall::open, Wall::fixed, Wall::free_slip}, 0.01,
               robust_set(), saved.geometry);
  saved.change(scene.method);
  const bool by_nodes = scene.method.ledger || scene.method.transfer == Transfer::apic;
  IdealGas gas = by_nodes ? robust_gas(0.02) : IdealGas{.mu = 0.02};
  add_body(scene, gas, lattice(0.1, 0, 1, -1, 1, [](double x, double y) { return x * x + y * y < 0.6; }), 1.3, 1);
  add_body(scene, Membrane{30, 0.3, true, Membrane::Kind::plane_stress}, arc(0, 0, 1, 0.9, -0.5, 0.5, 30, 0.05), 2);
  add_body(scene, Membrane{30, 0, true}, line(1.5, -1, 1.5, 1, 25, 0.05, true), 2);
  add_body(scene, plane_strain(20, 0.3), lattice(0.1, 1.1, 1.4, -0.3, 0.4), 2);
  scene.pinned = {scene.bodies[2].first, scene.bodies[2].first + scene.bodies[2].count - 1};
  scene.ambient = 0.3;
  scene.gravity = -0.2;
  set_velocities(scene, [](double x, double) { return x > 1.05 && x < 1.45 ? Vec<2>{-0.8, 0.1} : Vec<2>{0.2 * x, 0}; });
  return scene;
}

class Restored : public testing::TestWithParam<Saved> {};
INSTANTIATE_TEST_SUITE_P(Methods, Restored, testing::ValuesIn(methods),
                         [](const auto& info) { return std::string(info.param.name); });

void expect_same(const Running& a, const Running& b, const char* when) {
  for (const auto& take : {&Solver::points, &Solver::grid}) {
    const Snapshot one = (a.solver().*take)(), other = (b.solver().*take)();
    for (std::size_t k = 0; k < one.fields.size(); ++k)
      EXPECT_EQ(one.fields[k].values, other.fields[k].values) << one.fields[k].quantity.name << " " << when;
  }
  EXPECT_EQ(a.solver().record(), b.solver().record()) << when;
  EXPECT_EQ(a.solver().save(), b.solver().save()) << when;
}

TEST_P(Restored, GoesOnToTheLastBit) {
  Running whole(everything(GetParam())), fresh(everything(GetParam())), used(everything(GetParam()));
  whole.steps(37);
  used.steps(70);
  const SavedState saved = whole.solver().save();
  fresh.solver().restore(saved), used.solver().restore(saved);
  expect_same(fresh, whole, "at once"), expect_same(used, whole, "at once, into a used state");
  for (Running* run : {&whole, &fresh, &used}) run->steps(40);
  expect_same(fresh, whole, "later"), expect_same(used, whole, "later, in a used state");
}

}  // namespace
}  // namespace tether::mpm
