// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/reference/reference.hpp"

#include <fmt/format.h>

namespace tether {
namespace {

/// Says what the scene lacks for the solution; empty where it has all.
std::string lacks(ReferenceKind kind, const Scene& scene) {
  switch (kind) {
    case ReferenceKind::riemann:
      return lacks_for_riemann(scene);
    case ReferenceKind::spring:
      return lacks_for_spring(scene);
    case ReferenceKind::string:
      return lacks_for_string(scene);
    case ReferenceKind::pendulum:
      return lacks_for_pendulum(scene);
    case ReferenceKind::piston:
      return lacks_for_piston(scene);
    case ReferenceKind::radial_gas:
      return lacks_for_radial_gas(scene);
    case ReferenceKind::thin_ring:
      return lacks_for_thin_ring(scene);
    case ReferenceKind::none:
      break;
  }
  return "";
}

}  // namespace

ReferenceKind reference_kind(const std::string& name) {
  return find_word<ReferenceKind>(name).value_or(ReferenceKind::none);
}

std::optional<std::array<double, 2>> reference_window_of(const Deck& deck, const Scene& scene,
                                                         Diagnostics& diagnostics) {
  if (!deck.given("reference.window", 1) && !deck.given("reference.window", 2)) return std::nullopt;
  const auto tell = [&](Severity severity, const std::string& what, const std::string& hint) {
    if (diagnostics.has_errors()) return;
    const int at = deck.given("reference.window", 1) ? 1 : 2;
    diagnostics.add(deck.remark(severity, "reference.window", {at, 1}, what, hint));
  };
  if (!deck.given("reference.window", 1) || !deck.given("reference.window", 2)) {
    tell(Severity::error, "window has two numbers, where it begins and where it ends", "window=0.2,0.8, for example");
    return std::nullopt;
  }
  if (scene.reference != ReferenceKind::riemann) {
    tell(Severity::warning, "window has no effect: only the solution 'riemann' has one", "");
    return std::nullopt;
  }
  const double from = deck.real("reference.window", 1), to = deck.real("reference.window", 2);
  if (!(from < to) || from < scene.grid.x0 || to > scene.grid.x1) {
    tell(Severity::error, fmt::format("the window from {:.6g} to {:.6g} is no part of the tube", from, to),
         fmt::format("it begins at {:.6g} or later, and ends after that, at {:.6g} at the most", scene.grid.x0,
                     scene.grid.x1));
    return std::nullopt;
  }
  return std::array<double, 2>{from, to};
}

ReferenceKind reference_of(const Deck& deck, const Scene& scene, Diagnostics& diagnostics) {
  const std::string name = deck.text("reference.solution");
  const ReferenceKind kind = reference_kind(name);
  const std::string missing = lacks(kind, scene);
  if (!missing.empty() && !diagnostics.has_errors()) {
    diagnostics.add(deck.remark(Severity::error, "reference.solution", {1, 1},
                                fmt::format("the solution '{}' needs {}", name, missing),
                                "leave $reference out, or complete the deck"));
  }
  return kind;
}

}  // namespace tether
