// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/solids.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/diagnostics.hpp"
#include "base/numbers.hpp"
#include "grid/mesh_extent.hpp"

namespace tether {
namespace {

double value_of(const Expression& expression, double t, const std::string& of) {
  const double value = expression(std::array{t});
  if (std::isfinite(value)) return value;
  throw RunError(
      fmt::format("t = {:.9g}: the expression of {}, '{}', gives {}: likely cause, a division by zero or a "
                  "function outside its range",
                  t, of, expression.text(), value));
}

}  // namespace

double Amplitude::at(double t) const {
  if (expression) return value_of(*expression, t, of);
  if (time.empty()) return 1;
  const auto next = static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), t) - time.begin());
  if (next == 0) return factor.front();
  if (next == time.size()) return factor.back();
  const double part = (t - time[next - 1]) / (time[next] - time[next - 1]);
  return factor[next - 1] + part * (factor[next] - factor[next - 1]);
}

namespace {

/// The largest modulus of a law, that of being stretched alone one way [stress].
struct Stiffest {
  double operator()(const LinearElastic& law) const { return (*this)(law.law); }
  double operator()(const StVenantKirchhoff& law) const { return law.lambda + 2 * law.mu; }
  double operator()(const NeoHookean& law) const { return law.lambda + 2 * law.mu; }
  double operator()(const HoopFibre& law) const { return law.mu; }
};

/// The least distance of nodes of one element.
double least_distance(const Mesh& mesh) {
  const auto dim = static_cast<std::size_t>(mesh.dim());
  const int nodes = node_count_of(mesh.kind);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (int a = 1; a < nodes; ++a) {
      double squared = 0;
      for (std::size_t i = 0; i < dim; ++i) {
        const double d = mesh.x[at(mesh.element(e)[a]) * dim + i] - mesh.x[at(mesh.element(e)[0]) * dim + i];
        squared += d * d;
      }
      least = std::min(least, squared);
    }
  }
  return std::sqrt(least);
}

}  // namespace

double rounding_energy(const Solids& solids) {
  constexpr double moved = 1e-13;
  const MeshExtent extent(solids.mesh);
  double volume = 1, modulus = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(solids.mesh.dim()); ++i)
    volume *= extent.high[i] - extent.low[i];
  for (const SolidRegion& region : solids.regions) modulus = std::max(modulus, std::visit(Stiffest{}, region.law));
  const double strain = moved * extent.size() / least_distance(solids.mesh);
  return 0.5 * modulus * volume * strain * strain;
}

}  // namespace tether
