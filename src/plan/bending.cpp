// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/bending.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>
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

/// How far edges may lean, and of how many elements across. One q2 across with edges at 45 degrees is too stiff by some
/// per cent, at 72 degrees by half.
constexpr double told_lean = 50 * std::numbers::pi / 180;
constexpr int most_leaning = 3;

/// Modulus of the volume over that of shear from which there is a warning of law='svk'.
constexpr double least_held_trace = 50;

std::string body_name(const ElementsAcross& across, const Solids& solids) {
  const std::string first = solids.regions[static_cast<std::size_t>(across.regions.front())].name;
  const std::size_t others = across.regions.size() - 1;
  return others == 0 ? first : fmt::format("{} with {} joined to it", first, others);
}

/// Elements of order 1. Of elements h thick and a long in a body H thick, N = H/h across, a field of bending with the
/// curvature k leaves in a quadrilateral the shear k x, which has the energy G k^2 a^2/12 instead of none, and across
/// it the strain of the volume unrelieved: D k^2 h^2/12 instead of E' k^2 h^2/12, where D = lambda + 2 mu and E' is the
/// modulus of bending. Over the energy E' k^2 H^2/12 of the beam that is (G/E') (a/H)^2 + (D/E' - 1)/N^2. A triangle,
/// whose strain does not change within it, leaves three times that and twice the beam's own part, 2/N^2. Against static
/// cantilevers of ten times their thickness, nu from 0 to 0.49, N from 2 to 8 and a/h from 1/2 to 4, both are right
/// within a sixth of themselves. Hexahedra have a third direction to keep the volume in; 0.7 sqrt(D/E' - 1) is measured
/// there, for square bars and for plates. With the mean dilatation and its stabiliser the volume is not held, and of
/// D/E' - 1 is left 0.11 (2 nu)^4, measured. A body L long cannot be stiffer against bending than against shear:
/// s c/(s + c), c = (L/H)^2, is measured on panels of L/H 1 to 10 with nu up to 0.4999.
double too_stiff_of_order_1(ElementKind kind, const ElementsAcross& across, double lambda, double mu, bool mean) {
  const double H = across.thickness, N = across.count, D = lambda + 2 * mu, E = 4 * mu * (lambda + mu) / D;
  const double unrelieved = mean ? 0.11 * std::pow(lambda / (lambda + mu), 4) : D / E - 1;
  const double shear = mu / E * std::pow(across.along / H, 2), volume = unrelieved / (N * N);
  double s = shear + volume;
  if (kind == ElementKind::hex8 && !mean) s = shear + 0.7 * std::sqrt(std::fmax(D / E - 1, 0)) / (N * N);
  if (is_simplex(kind)) s = 3 * (shear + volume) + 2 / (N * N);
  const double most = std::pow(std::max(across.longest / H, 1.0), 2);
  return s * most / (s + most);
}

/// Elements of order 2 follow a constant curvature. What is left was measured on static cantilevers of L/H = 5, 10 and
/// 20 with nu from 0 to 0.499, N from 1 to 3 and a/h of 1, 2 and 4, and is right within 2 % of the stiffness. A
/// curvature that changes along an element leaves c (a/H)^2 (a/L)^2. Where a body is clamped its change across is held:
/// too coarse a field there makes it stiffer. The mean dilatation makes a single layer softer: a q2 element near the
/// clamp alone, a p2 element, whose stabiliser is small, all along. With the volume of points elements lock as nu nears
/// 0.5, which is right within half of itself.
double too_stiff_of_order_2(ElementKind kind, const ElementsAcross& across, double lambda, double mu, bool mean) {
  const double H = across.thickness, N = across.count, nu2 = lambda / (lambda + mu);  // 2 nu
  const double a = across.along / H, slenderness = std::max(across.longest / H, 1.0);
  const double D = lambda + 2 * mu, E = 4 * mu * (lambda + mu) / D;
  const double held = nu2 * nu2 * a / slenderness;
  const double part = across.along / across.longest, most = 0.25 * part * part;
  const double curved = 3 * std::pow(across.bulge / H, 2);
  // The smaller of both, smoothly: a curvature that changes along an element, and one that no element follows.
  const auto changing = [&](double c) { return 1 / std::hypot(1 / (c * std::pow(a * part, 2)), 1 / most); };
  if (is_simplex(kind)) {
    const double stiff = changing(0.012) + (mean ? 0.25 : 0.4) * held;
    if (!mean) return stiff + 0.085 * std::pow(std::max(D / E - 4.0 / 3, 0.0), 0.3) / std::pow(N, 1.6);
    return stiff - 0.2 * std::pow(std::max(3 * nu2 - 2, 0.0), 1.5) / std::pow(N, 2.4);
  }
  const double stiff = changing(0.0085) + 0.065 * held * std::sqrt(a);
  if (!mean) return stiff + curved + 0.047 * std::pow(std::max(D / E - 1, 0.0), 0.3) / std::pow(N, 1.2);
  return stiff - curved - (N == 1 ? 0.15 * nu2 * nu2 / slenderness : 0);
}

/// The elements of order 2 that plan offers in place of others: quadrilaterals, but for a body of triangles of order 2.
ElementKind offered(ElementKind kind) {
  return is_simplex(kind) && order_of(kind) == 2 ? kind : element_kind("q2", dimension_of(kind));
}

/// The fewest elements of order 2 across that are off by little, as long as the body is thick or a quarter of its
/// length.
void find_better(const ElementsAcross& across, ElementKind kind, const Lame& l, Bending& body) {
  constexpr int most = 4;
  ElementsAcross better = across;
  better.along = std::min(across.thickness, 0.25 * across.longest);
  better.bulge = across.bulge * std::pow(better.along / across.along, 2);
  for (better.count = 1; better.count <= most; ++better.count) {
    body.better_across = static_cast<int>(better.count), body.better_along = better.along;
    body.better_off = too_stiff_of_order_2(offered(kind), better, l.lambda, l.mu, true);
    if (std::abs(body.better_off) <= good_stiffness) return;
  }
}

/// That elements are too stiff, or too soft.
const char* verb(bool locks, bool one) {
  if (locks) return one ? "locks" : "lock";
  return one ? "gives way" : "give way";
}

/// Whether the elements that are offered are worth it: twice as good at least.
bool has_better(const Bending& body) { return std::abs(body.better_off) < 0.5 * std::abs(body.too_stiff); }

std::string off_text(double too_stiff) {
  return fmt::format("too {} by about {:.2g} %", too_stiff < 0 ? "soft" : "stiff", 100 * std::abs(too_stiff));
}

}  // namespace

double bending_too_stiff(ElementKind kind, const ElementsAcross& across, double lambda, double mu, bool mean) {
  return order_of(kind) == 1 ? too_stiff_of_order_1(kind, across, lambda, mu, mean)
                             : too_stiff_of_order_2(kind, across, lambda, mu, mean);
}

std::vector<Bending> bending_of(const Solids& solids) {
  std::vector<Bending> bodies;
  const std::vector<ElementsAcross> parts = elements_across(solids.mesh);
  const std::vector<bool> held = parts.empty() ? std::vector<bool>() : held_parts(solids);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const ElementsAcross& across = parts[p];
    Bending body{.body = body_name(across, solids),
                 .across = static_cast<int>(across.count),
                 .thickness = across.thickness,
                 .lean = across.lean,
                 .bends = held[p] || across.longest >= slender * across.thickness};
    bool any = false;
    for (const int r : across.regions) {
      const ElasticLaw& law = solids.regions[static_cast<std::size_t>(r)].law;
      const std::optional<Lame> l = std::visit([](const auto& of) { return of.in_plane(); }, law);
      if (!l) continue;
      const double s = bending_too_stiff(solids.mesh.kind, across, l->lambda, l->mu,
                                         dilatation_of(solids.dilatation, solids.mesh.kind, law).mean);
      if (any && std::abs(s) <= std::abs(body.too_stiff)) continue;
      any = true, body.too_stiff = s;
      body.nu = poisson_ratio(*l, std::visit([](const auto& of) { return of.plane_stress(); }, law));
      find_better(across, solids.mesh.kind, *l, body);
    }
    if (!any) continue;
    const double fewer = std::sqrt(std::abs(body.too_stiff) / told_stiffness);
    body.enough = static_cast<int>(std::ceil(across.count * fewer));
    bodies.push_back(body);
  }
  return bodies;
}

std::string bending_warning(const std::vector<Bending>& bodies, const Solids& solids) {
  const auto told = [](const Bending& body) { return body.bends && std::abs(body.too_stiff) >= told_stiffness; };
  if (std::ranges::none_of(bodies, told)) return "";
  const Bending& worst = *std::ranges::max_element(
      bodies, {}, [&](const Bending& body) { return told(body) ? std::abs(body.too_stiff) : 0; });
  const auto others = std::ranges::count_if(bodies, told) - 1;
  const bool one = worst.across == 1, locks = worst.too_stiff > 0;
  const double deflection = 1 / (1 + worst.too_stiff) - 1;
  std::string text = fmt::format(
      "{}: {} {} element{} across its thickness {:.3g} with nu = {:.4g} {} where it bends: it is about {:.0f} % too "
      "{} and deflects {:.0f} % too {}",
      worst.body, worst.across, element_name(solids.mesh.kind), one ? "" : "s", worst.thickness, worst.nu,
      verb(locks, one), 100 * std::abs(worst.too_stiff), locks ? "stiff" : "soft", 100 * std::abs(deflection),
      locks ? "little" : "far");
  if (order_of(solids.mesh.kind) == 1)
    text += fmt::format("; about {} across leave {:.0f} %", worst.enough, 100 * told_stiffness);
  if (has_better(worst))
    text += fmt::format("{} element='{}' with {} across, each {:.3g} long, leaves {:.2g} %",
                        order_of(solids.mesh.kind) == 1 ? "," : ";", element_name(offered(solids.mesh.kind)),
                        worst.better_across, worst.better_along, 100 * std::abs(worst.better_off));
  if (others == 0) return text;
  return text + fmt::format("; {} other bod{} off by no more than this", others, others == 1 ? "y is" : "ies are");
}

std::string lean_warning(const std::vector<Bending>& bodies) {
  for (const Bending& body : bodies) {
    if (!body.bends || body.across > most_leaning || body.lean < told_lean) continue;
    return fmt::format(
        "{}: edges of its elements, of which {} lie{} across its thickness {:.3g}, lean by {:.0f} degrees: where it "
        "bends it is stiffer than is estimated; more across, or edges at right angles to it, bend as they should",
        body.body, body.across, body.across == 1 ? "s" : "", body.thickness, body.lean * 180 / std::numbers::pi);
  }
  return "";
}

std::string trace_warning(const Solids& solids) {
  for (const SolidRegion& region : solids.regions) {
    const auto* law = std::get_if<StVenantKirchhoff>(&region.law);
    if (!law || law->plane_stress() || law->lambda < least_held_trace * law->mu) continue;
    return fmt::format(
        "{}: law='svk' with nu = {:.7g} holds the trace of the strain, which is the volume of small strains alone: "
        "from strains of about {:.1g} on elements lock; law='neo-hookean' holds the volume itself",
        region.name, poisson_ratio({law->lambda, law->mu}), std::sqrt(law->mu / law->lambda));
  }
  return "";
}

std::string bending_text(const std::vector<Bending>& bodies, const Solids& solids) {
  std::string text;
  for (const Bending& body : bodies) {
    if (!body.bends) continue;
    text += fmt::format("  {}: {} {} across {:.3g} with nu = {:.4g}: {}\n", body.body, body.across,
                        element_name(solids.mesh.kind), body.thickness, body.nu, off_text(body.too_stiff));
    if (std::abs(body.too_stiff) > good_stiffness && has_better(body))
      text += fmt::format("    better: {} {} across, each {:.3g} long: {}\n", body.better_across,
                          element_name(offered(solids.mesh.kind)), body.better_along, off_text(body.better_off));
  }
  return text.empty() ? "" : "bending, as estimated:\n" + text;
}

}  // namespace tether
