// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/materials.hpp"

#include <fmt/format.h>
#include <functional>

#include "deck/words.hpp"
#include "read/method.hpp"
#include "read/points/geometry.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

/// A word of $reg, or where it has none and there is a mesh, of $fem.
std::string word_of_region(const Deck& deck, TextVariable of_reg, TextVariable of_fem, int r) {
  if (deck.given(of_reg, r)) return deck.text(of_reg, r);
  return deck.has_group("mesh") || deck.has_group("fem") ? deck.text(of_fem, r) : "";
}

}  // namespace

std::string law_word(const Deck& deck, int r) { return word_of_region(deck, "reg.law", "fem.law", r); }

ElasticConstants elastic_constants(const Deck& deck, int r, Plane plane) {
  const std::string volumetric = word_of_region(deck, "reg.volumetric", "fem.volumetric", r);
  return {.E = deck.real("reg.matr", 1, r),
          .nu = deck.real("reg.matr", 2, r),
          .plane = plane,
          .volumetric = find_word<Volumetric>(volumetric).value_or(Volumetric::log),
          .centre_x = deck.real("fem.fibre_x", r),
          .centre_y = deck.real("fem.fibre_y", r)};
}

void check_law_words(const Deck& deck, int r, Diagnostics& diagnostics) {
  constexpr std::array<std::array<TextVariable, 2>, 2> words{
      {{"reg.law", "fem.law"}, {"reg.volumetric", "fem.volumetric"}}};
  for (const auto& [name, of_fem] : words) {
    if (!deck.given(name, r) || !deck.given(of_fem, r)) continue;
    const std::string here = deck.text(name, r), there = deck.text(of_fem, r);
    if (here == there) continue;
    diagnostics.add(
        deck.remark(Severity::error, name, {r, 1},
                    fmt::format("region {} has two of it: {} = '{}' here and '{}' in $fem", r, name, here, there),
                    "leave one of them away"));
  }
}

namespace {

constexpr const char* no_plane_stress = "plane stress has no meaning about an axis, where the hoop carries too";
constexpr const char* use_three_stresses = "about an axis ipath(4) = 0 is the elastic law";

/// Reports a mistake in one of the law's numbers at its place: which number, what is wrong, what would be right.
using Refuse = std::function<void(int constant, const std::string& message, const std::string& hint)>;

std::optional<Material> elastic(int ipath, double E, double nu, const Refuse& refuse) {
  const bool strain = ipath == 0;
  if (!(E > 0)) refuse(1, fmt::format("an elastic solid needs Young's modulus > 0, not {:.6g}", E), "constant 1 is E");
  if (!(nu > -1) || !(strain ? nu < 0.5 : nu <= 0.5)) {
    refuse(2, fmt::format("Poisson's ratio {:.6g} is out of range", nu),
           strain ? "plane strain takes -1 < nu < 0.5" : "plane stress takes -1 < nu <= 0.5");
  }
  return strain ? plane_strain(E, nu) : plane_stress(E, nu);
}

/// Points without a word, and 'linear' ones, follow their rates of strain.
bool is_finite(const std::string& word) { return !word.empty() && word != LinearElastic::word; }

/// A law of F, by its word.
std::optional<Material> finite(const Deck& deck, int r, int ipath, const Refuse& refuse) {
  const ElasticConstants given = elastic_constants(deck, r, ipath == 2 ? Plane::stress : Plane::strain);
  const std::string word = law_word(deck, r);
  if (!(given.E > 0))
    refuse(1, fmt::format("an elastic solid needs Young's modulus > 0, not {:.6g}", given.E), "constant 1 is E");
  if (!(given.nu > -1) || !(given.nu < 0.5)) {
    refuse(2, fmt::format("Poisson's ratio {:.6g} is out of range", given.nu),
           fmt::format("'{}' takes -1 < nu < 0.5", word));
    return std::nullopt;
  }
  const auto law = law_of_word<PointLaw>(word, given);
  return law ? std::optional<Material>(FiniteElastic{*law, given.E, given.nu}) : std::nullopt;
}

/// Warns of words that say how elastic regions answer, where region r is none of theirs.
void warn_of_unused_law(const Deck& deck, int r, int ipath, Diagnostics& diagnostics) {
  const bool elastic = ipath == 0 || ipath == 2;
  for (const AnyVariable name : Variables{"reg.law", "reg.volumetric"}) {
    const bool used = elastic && (name == "reg.law" || law_word(deck, r) == NeoHookean::word);
    if (used || !deck.given(name, r)) continue;
    diagnostics.add(deck.remark(
        Severity::warning, name, {r, 1},
        fmt::format("{} has no effect: region {} is {}", name, r, elastic ? "not neo-hookean" : "not elastic"),
        "leave it away"));
  }
}

/// The particle file's string, which is membrane 1.
Material string(const Deck& deck, double E, double nu, const Refuse& refuse) {
  if (!(E > 0)) refuse(1, fmt::format("a string needs Young's modulus > 0, not {:.6g}", E), "constant 1 is E");
  const Membrane law = membrane_law(deck, 1, E, nu);
  if (law.kind == Membrane::Kind::plane_stress && !(nu > -1 && nu <= 0.5))
    refuse(2, fmt::format("Poisson's ratio {:.6g} is out of range", nu), "plane stress takes -1 < nu <= 0.5");
  return law;
}

std::optional<Material> gas(const Deck& deck, int ipath, int r, Diagnostics& diagnostics) {
  IdealGas law;
  law.gm1 = deck.real("fluid.gm1");
  law.mu = deck.real("fluid.mu");
  law.lambda = deck.real("fluid.lambda");
  law.coef1 = deck.real("fluid.coef1");
  law.coef2 = deck.real("fluid.coef2");
  const ViscosityOf own = is_robust(deck) ? ViscosityOf::local : ViscosityOf::deck;
  if (word_or(deck, "mpm.viscosity", own) == ViscosityOf::local)
    law.lambda = law.coef1 = law.coef2 = 1, law.local_speed = true;
  law.rule = ipath == 9 ? DensityRule::quadratic : DensityRule::continuity;
  if (is_robust(deck)) law.rule = DensityRule::grid;
  if (!deck.given("mpm.density")) return law;
  law.rule = word<DensityRule>(deck, "mpm.density");
  if (law.rule != (ipath == 9 ? DensityRule::quadratic : DensityRule::continuity)) {
    diagnostics.add(deck.remark(
        Severity::remark, "mpm.density", {1, 1},
        fmt::format("density = '{}' wins over ipath(4,{}) = {} of region {}", word_of(law.rule), r, ipath, r)));
  }
  return law;
}

}  // namespace

Membrane membrane_law(const Deck& deck, int b, double E, double nu) {
  return {E, nu, deck.logical("membrane.wrinkle", b), word<Membrane::Kind>(deck, "membrane.law", b)};
}

std::optional<Material> region_material(const Deck& deck, int r, Diagnostics& diagnostics) {
  const int ipath = deck.given("reg.ipath", 4, r) ? deck.integer("reg.ipath", 4, r) : -1;
  const double first = deck.real("reg.matr", 1, r);
  const Refuse refuse = [&](int constant, const std::string& message, const std::string& hint) {
    diagnostics.add(
        deck.remark(Severity::error, "reg.matr", {constant, r}, fmt::format("region {}: {}", r, message), hint));
  };
  if (ipath == 2 && geometry_of(deck) == Geometry::axisymmetric) {
    diagnostics.add(deck.remark(Severity::error, "reg.ipath", {4, r}, fmt::format("region {}: {}", r, no_plane_stress),
                                use_three_stresses));
  }
  warn_of_unused_law(deck, r, ipath, diagnostics);
  switch (ipath) {
    case 0:
    case 2:
      if (is_finite(law_word(deck, r))) return finite(deck, r, ipath, refuse);
      return elastic(ipath, first, deck.real("reg.matr", 2, r), refuse);
    case 7:
    case 9:
      return gas(deck, ipath, r, diagnostics);
    case 8:
      if (!(first > 0))
        refuse(1, fmt::format("a linear fluid needs its bulk modulus > 0, not {:.6g}", first), "matr(1) is beta");
      if (deck.real("reg.matr", 2, r) < 0)
        refuse(2, fmt::format("a linear fluid needs its viscosity >= 0, not {:.6g}", deck.real("reg.matr", 2, r)),
               "matr(2) is mu");
      return LinearFluid{first, deck.real("reg.matr", 2, r)};
    default:
      break;
  }
  diagnostics.add(deck.remark(
      Severity::error, "reg.ipath", {4, r},
      ipath == -1 ? fmt::format("region {}: ipath(4,{}) is not given", r, r)
                  : fmt::format("region {}: ipath(4) = {} names no law", r, ipath),
      "0 plane strain, 2 plane stress, 7 gas with continuity density, 9 gas with quadratic density, 8 linear fluid"));
  return std::nullopt;
}

std::optional<Material> file_material(const Deck& deck, const ParticleFile& file, Diagnostics& diagnostics) {
  const auto tell = [&](int line, const std::string& message, const std::string& hint) {
    diagnostics.error({file.file, line, 1}, line_text(file, line), message, hint);
  };
  const Refuse refuse = [&](int, const std::string& message, const std::string& hint) {
    tell(file.constants_line, message, hint);
  };
  const double E = file.constants[0], nu = file.constants[1];
  if (file.ipath[3] == 2 && geometry_of(deck) == Geometry::axisymmetric)
    tell(file.ipath_line, no_plane_stress, use_three_stresses);
  switch (file.ipath[3]) {
    case 0:
    case 2:
      return elastic(file.ipath[3], E, nu, refuse);
    case 8:
      return string(deck, E, nu, refuse);
    default:
      break;
  }
  tell(file.ipath_line, fmt::format("ipath(4) = {} in a particle file names no law", file.ipath[3]),
       "0 plane strain, 2 plane stress, 8 string or membrane; gas comes from a region, which has its energy in siep");
  return std::nullopt;
}

}  // namespace tether
