// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/plan.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <optional>

namespace tether {
namespace {

/// In plane stress lambda is 2 mu nu/(1 - nu), else 2 mu nu/(1 - 2 nu).
double poisson_ratio(const Lame& l, bool plane_stress) {
  return plane_stress ? l.lambda / (l.lambda + 2 * l.mu) : poisson_ratio(l);
}

/// Longest extent over the thickness from which a body bends that nothing holds: shorter ones, of which their own
/// inertia or a fluid is all that acts on them, are squeezed and turned.
constexpr double slender = 2;

/// Says of each connected part of the mesh whether it is held.
std::vector<bool> held_parts(const Solids& solids) {
  const std::vector<int> part = parts_of(solids.mesh);
  std::vector<bool> held(static_cast<std::size_t>(count_parts(solids.mesh)), false);
  for (const Support& support : solids.supports) {
    for (const int n : support.nodes) {
      if (part[static_cast<std::size_t>(n)] >= 0)
        held[static_cast<std::size_t>(part[static_cast<std::size_t>(n)])] = true;
    }
  }
  return held;
}

std::string body_name(const ElementsAcross& across, const Solids& solids) {
  const std::string first = solids.regions[static_cast<std::size_t>(across.regions.front())].name;
  const std::size_t others = across.regions.size() - 1;
  return others == 0 ? first : fmt::format("{} with {} joined to it", first, others);
}

}  // namespace

/// Estimates by how much the body is too stiff. Of elements h thick and a long in a body H thick, N = H/h across, a
/// field of bending with the curvature k leaves in a quadrilateral the shear k x, which has the energy G k^2 a^2/12
/// instead of none, and across it the strain
/// of the volume unrelieved: D k^2 h^2/12 instead of E' k^2 h^2/12, where D = lambda + 2 mu and E' is the modulus of
/// bending. Over the energy E' k^2 H^2/12 of the beam that is (G/E') (a/H)^2 + (D/E' - 1)/N^2. A triangle, whose strain
/// does not change within it, leaves three times that and twice the beam's own part, 2/N^2. Against static cantilevers
/// of ten times their thickness, nu from 0 to 0.49, N from 2 to 8 and a/h from 1/2 to 4, both are right within a sixth
/// of themselves. Hexahedra have a third direction to keep the volume in; 0.7 sqrt(D/E' - 1) is measured there, for
/// square bars and for plates. With the mean dilatation and its stabiliser the volume is not held, and of D/E' - 1 is
/// left 0.11 (2 nu)^4, measured. A body L long cannot be stiffer against bending than against shear: s c/(s + c), c =
/// (L/H)^2, is measured on panels of L/H 1 to 10 with nu up to 0.4999.
double bending_too_stiff(ElementKind kind, const ElementsAcross& across, double lambda, double mu, bool mean) {
  const double H = across.thickness, N = across.count, D = lambda + 2 * mu, E = 4 * mu * (lambda + mu) / D;
  const double unrelieved = mean ? 0.11 * std::pow(lambda / (lambda + mu), 4) : D / E - 1;
  const double shear = mu / E * std::pow(across.along / H, 2), volume = unrelieved / (N * N);
  double s = shear + volume;
  if (kind == ElementKind::hex8 && !mean) s = shear + 0.7 * std::sqrt(std::fmax(D / E - 1, 0)) / (N * N);
  if (is_simplex(kind)) s = 3 * (shear + volume) + 2 / (N * N);
  const double most = std::pow(std::max(across.longest / H, 1.0), 2);
  return s * most / (s + most);
}

std::vector<Locking> locking_of(const Solids& solids) {
  std::vector<Locking> bodies;
  const std::vector<ElementsAcross> parts = elements_across(solids.mesh);
  const std::vector<bool> held = parts.empty() ? std::vector<bool>() : held_parts(solids);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const ElementsAcross& across = parts[p];
    Locking body{.body = body_name(across, solids),
                 .across = static_cast<int>(across.count),
                 .thickness = across.thickness,
                 .too_stiff = -1,
                 .bends = held[p] || across.longest >= slender * across.thickness};
    for (const int r : across.regions) {
      const ElasticLaw& law = solids.regions[static_cast<std::size_t>(r)].law;
      const std::optional<Lame> l = std::visit([](const auto& of) { return of.in_plane(); }, law);
      if (!l) continue;
      const double s = bending_too_stiff(solids.mesh.kind, across, l->lambda, l->mu,
                                         dilatation_of(solids.dilatation, solids.mesh.kind, law).mean);
      if (s > body.too_stiff)
        body.too_stiff = s,
        body.nu = poisson_ratio(*l, std::visit([](const auto& of) { return of.plane_stress(); }, law));
    }
    if (body.too_stiff < 0) continue;
    body.enough = static_cast<int>(std::ceil(across.count * std::sqrt(body.too_stiff / told_stiffness)));
    bodies.push_back(body);
  }
  return bodies;
}

std::string locking_warning(const std::vector<Locking>& bodies, const Solids& solids) {
  const auto told = [](const Locking& body) { return body.bends && body.too_stiff >= told_stiffness; };
  if (std::ranges::none_of(bodies, told)) return "";
  const Locking& worst =
      *std::ranges::max_element(bodies, {}, [&](const Locking& body) { return told(body) ? body.too_stiff : 0; });
  const auto others = std::ranges::count_if(bodies, told) - 1;
  const bool one = worst.across == 1;
  return fmt::format(
      "{}: {} {} element{} across its thickness {:.3g} with nu = {:.4g} lock{} where it bends: it is about {:.0f} % "
      "too stiff and deflects {:.0f} % too little; about {} across leave {:.0f} %, element='q2' hardly locks{}",
      worst.body, worst.across, element_name(solids.mesh.kind), one ? "" : "s", worst.thickness, worst.nu,
      one ? "s" : "", 100 * worst.too_stiff, 100 * worst.too_stiff / (1 + worst.too_stiff), worst.enough,
      100 * told_stiffness,
      others == 0 ? ""
                  : fmt::format("; {} other bod{} no more than this", others, others == 1 ? "y locks" : "ies lock"));
}

}  // namespace tether
