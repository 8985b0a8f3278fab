// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/method_of_deck.hpp"

#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace tether {
namespace {

/// The set of method='robust'.
Method robust_set() {
  Method set;
  set.order = StressOrder::usf;
  set.kernel = Kernel::bspline;
  set.transfer = Transfer::apic;
  set.gas_energy = GasEnergy::centred;
  set.contact = ContactRule::gap;
  set.membrane_strain = MembraneStrain::element;
  set.ledger = true;
  return set;
}

/// The enumerator that a text stands for, `otherwise` where the deck gives none.
template <class T, std::size_t n>
T chosen(const Deck& deck, const char* group, const char* name, const std::array<std::pair<std::string_view, T>, n>& of,
         T otherwise) {
  if (!deck.given(group, name)) return otherwise;
  const std::string text = deck.text(group, name);
  for (const auto& [word, value] : of) {
    if (word == text) return value;
  }
  return otherwise;
}

template <class T>
using Word = std::pair<std::string_view, T>;

constexpr std::array orders{Word<StressOrder>{"musl", StressOrder::musl}, Word<StressOrder>{"usf", StressOrder::usf},
                            Word<StressOrder>{"usl", StressOrder::usl}};
constexpr std::array kernels{Word<Kernel>{"linear", Kernel::linear}, Word<Kernel>{"bspline", Kernel::bspline}};
constexpr std::array transfers{Word<Transfer>{"flip", Transfer::flip}, Word<Transfer>{"apic", Transfer::apic}};
constexpr std::array energies{Word<GasEnergy>{"rate", GasEnergy::rate}, Word<GasEnergy>{"centred", GasEnergy::centred}};
constexpr std::array contacts{Word<ContactRule>{"none", ContactRule::none},
                              Word<ContactRule>{"release", ContactRule::release},
                              Word<ContactRule>{"gap", ContactRule::gap}};
constexpr std::array strains{Word<MembraneStrain>{"point", MembraneStrain::point},
                             Word<MembraneStrain>{"element", MembraneStrain::element}};
constexpr std::array normals{Word<NormalRule>{"connectivity", NormalRule::connectivity},
                             Word<NormalRule>{"color", NormalRule::color},
                             Word<NormalRule>{"quadratic", NormalRule::quadratic},
                             Word<NormalRule>{"cubic", NormalRule::cubic},
                             Word<NormalRule>{"mass-linear", NormalRule::mass_linear},
                             Word<NormalRule>{"mass-quadratic", NormalRule::mass_quadratic}};
constexpr std::array scopes{Word<MatrixScope>{"cell", MatrixScope::cell},
                            Word<MatrixScope>{"membrane", MatrixScope::membrane}};
constexpr std::array lone_points{Word<LonePoint>{"ghost", LonePoint::ghost},
                                 Word<LonePoint>{"previous", LonePoint::previous}};

/// Whether all that the ledger books is there.
bool books(const Deck& deck, const Method& method) {
  const bool grid = deck.given("mpm", "density") ? deck.text("mpm", "density") == "grid" : is_robust(deck);
  return grid && method.order == StressOrder::usf && method.transfer == Transfer::apic &&
         method.kernel == Kernel::bspline && method.gas_energy == GasEnergy::centred;
}

/// What a part of the set needs of others; a part that the deck does not give falls with what it needs.
void drop_what_lacks_its_ground(const Deck& deck, Method& method) {
  const bool usf = method.order == StressOrder::usf;
  if (!usf && !deck.given("mpm", "energy")) method.gas_energy = GasEnergy::rate;
  if (!usf && method.kernel == Kernel::bspline && !deck.given("mpm", "contact")) method.contact = ContactRule::none;
  if (!books(deck, method) && !deck.given("mpm", "ledger")) method.ledger = false;
}

void check(const Deck& deck, const Method& method, Diagnostics& diagnostics) {
  const auto refuse = [&](const char* name, const char* what, const char* hint) {
    diagnostics.add(deck.remark(Severity::error, "mpm", name, {1, 1}, what, hint));
  };
  const bool usf = method.order == StressOrder::usf;
  if (method.gas_energy == GasEnergy::centred && !usf) {
    refuse("energy", "energy = 'centred' needs order = 'usf'", "only then the velocities before and after meet");
  }
  if (method.contact != ContactRule::none && method.kernel == Kernel::bspline && !usf) {
    refuse("contact", "contact with kernel = 'bspline' needs order = 'usf'", "or take kernel = 'linear'");
  }
  if (method.ledger && !books(deck, method)) {
    refuse("ledger",
           "the ledger needs order 'usf', transfer 'apic', kernel 'bspline', energy 'centred' and density 'grid'",
           "it books what these lose; write ledger=.false.");
  }
}

}  // namespace

bool is_robust(const Deck& deck) { return deck.text("mpm", "method") == "robust"; }

double cfl_of(const Deck& deck) {
  if (deck.given("mpm", "cfl")) return deck.real("mpm", "cfl");
  return is_robust(deck) ? 0.65 : 1.0;
}

Method method_of(const Deck& deck, Diagnostics& diagnostics) {
  Method method = is_robust(deck) ? robust_set() : Method{};
  method.order = chosen(deck, "mpm", "order", orders, method.order);
  method.kernel = chosen(deck, "mpm", "kernel", kernels, method.kernel);
  method.transfer = chosen(deck, "mpm", "transfer", transfers, method.transfer);
  method.gas_energy = chosen(deck, "mpm", "energy", energies, method.gas_energy);
  method.contact = chosen(deck, "mpm", "contact", contacts, method.contact);
  method.criterion = deck.integer("mpm", "criterion");
  method.membrane_strain = chosen(deck, "membrane", "strain", strains, method.membrane_strain);
  method.normals = chosen(deck, "membrane", "normals", normals, method.normals);
  method.matrix = chosen(deck, "membrane", "matrix", scopes, method.matrix);
  method.lone_point = chosen(deck, "membrane", "alone", lone_points, method.lone_point);
  if (deck.given("mpm", "ledger")) method.ledger = deck.logical("mpm", "ledger");
  method.jaumann = deck.logical("mpm", "jaumann");
  drop_what_lacks_its_ground(deck, method);
  check(deck, method, diagnostics);
  return method;
}

}  // namespace tether
