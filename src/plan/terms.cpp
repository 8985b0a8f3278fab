// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/terms.hpp"

#include <fmt/format.h>

namespace tether {
namespace {

struct Namer {
  std::string operator()(const PlaneElastic& law) const {
    return fmt::format("linear elastic, plane {} (E {:.4g}, nu {:.3g})",
                       law.plane == PlaneElastic::Plane::strain ? "strain" : "stress", law.E, law.nu);
  }
  std::string operator()(const IdealGas& gas) const {
    const char* rule = gas.rule == DensityRule::cell        ? "by cell (4.5)"
                       : gas.rule == DensityRule::quadratic ? "by quadratic interpolation (4.6)"
                                                            : "by continuity (4.7)";
    return fmt::format("ideal gas, gamma {:.4g}, density {}", gas.gm1 + 1, rule);
  }
  std::string operator()(const LinearFluid& law) const {
    return fmt::format("linear fluid, beta {:.4g} (6.1)", law.beta);
  }
  std::string operator()(const Uniaxial& law) const {
    return fmt::format("string, E {:.4g}, {}", law.E, law.wrinkle ? "one-way" : "two-way");
  }
};

std::string order_reason(StressOrder order) {
  switch (order) {
    case StressOrder::usf:
      return "first, from the mapped velocity (usf)";
    case StressOrder::usl:
      return "last, from the solution of the momentum equation (usl)";
    case StressOrder::musl:
      break;
  }
  return "last, from the point momenta mapped back (musl, the thesis')";
}

}  // namespace

std::string material_name(const Material& material) { return std::visit(Namer{}, material); }

std::vector<Term> terms_of(const Scene& scene) {
  const Body* gas_body = find_body<IdealGas>(scene);
  const IdealGas* gas = gas_body ? &std::get<IdealGas>(gas_body->material) : nullptr;
  const bool strings = find_body<Uniaxial>(scene) != nullptr;
  const bool shocks = gas && gas->lambda != 0 && (gas->coef1 != 0 || gas->coef2 != 0);
  const auto term = [](const char* name, bool on, const std::string& yes, const std::string& no) {
    return Term{name, on, on ? yes : no};
  };
  return {
      {"stress update", true, order_reason(scene.order)},
      term("gravity", scene.gravity != 0, fmt::format("gravc = {:.6g} in y", scene.gravity), "gravc = 0"),
      term("energy equation (4.8)", gas, "a gas is there", "no gas"),
      term("viscosity (4.1)", gas && gas->mu != 0, "mu > 0", gas ? "mu = 0" : "no gas"),
      term("artificial viscosity (4.11)", shocks, "lambda and a coefficient > 0",
           gas ? "lambda or both coefficients are 0" : "no gas"),
      term("tangents (7.1)", strings, "a string is there, connected in file order", "no string"),
      {"contact and release", false,
       "bodies share one velocity field where they share a node, as in the thesis' basic method"},
      {"heat conduction", false, "not in the source's energy equation (4.8)"},
      {"third dimension", false, "the scene is plane, one unit deep"},
  };
}

}  // namespace tether
