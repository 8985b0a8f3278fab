// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/method.hpp"

#include <fmt/format.h>

#include "deck/words.hpp"
#include "laws/fluids.hpp"
#include "read/values.hpp"

namespace tether {
namespace {

/// Returns whether all that the ledger books is there.
bool books(const Deck& deck, const Method& method) {
  const bool grid =
      word_or(deck, "mpm.density", is_robust(deck) ? DensityRule::grid : DensityRule::continuity) == DensityRule::grid;
  return grid && method.order == StressOrder::usf && method.transfer == Transfer::apic &&
         method.kernel == Kernel::bspline && method.gas_energy == GasEnergy::centred;
}

/// Drops what lacks the parts of the set that it needs; a part that the deck does not give falls with what it needs.
void drop_what_lacks_its_ground(const Deck& deck, Method& method) {
  const bool usf = method.order == StressOrder::usf;
  if (!usf && !deck.given("mpm.energy")) method.gas_energy = GasEnergy::rate;
  if (!usf && method.kernel == Kernel::bspline && !deck.given("mpm.contact")) method.contact = ContactRule::none;
  if (!books(deck, method) && !deck.given("mpm.ledger")) method.ledger = false;
}

void check(const Deck& deck, const Method& method, Diagnostics& diagnostics) {
  const auto refuse = [&](AnyVariable name, const char* what, const char* hint) {
    diagnostics.add(deck.remark(Severity::error, name, {1, 1}, what, hint));
  };
  const bool usf = method.order == StressOrder::usf;
  if (method.gas_energy == GasEnergy::centred && !usf) {
    refuse("mpm.energy", "energy = 'centred' needs order = 'usf'", "only then the velocities before and after meet");
  }
  if (method.contact != ContactRule::none && method.kernel == Kernel::bspline && !usf) {
    refuse("mpm.contact", "contact with kernel = 'bspline' needs order = 'usf'", "or take kernel = 'linear'");
  }
  if (method.ledger && !books(deck, method)) {
    refuse("mpm.ledger",
           "the ledger needs order 'usf', transfer 'apic', kernel 'bspline', energy 'centred' and density 'grid'",
           "it books what these lose; write ledger=.false.");
  }
}

}  // namespace

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

bool is_robust(const Deck& deck) { return word<MpmSet>(deck, "mpm.method") == MpmSet::robust; }

double cfl_of(const Deck& deck) {
  if (deck.given("mpm.cfl")) return deck.real("mpm.cfl");
  return is_robust(deck) ? 0.65 : 1.0;
}

Method method_of(const Deck& deck, Diagnostics& diagnostics) {
  Method method = is_robust(deck) ? robust_set() : Method{};
  method.order = word_or(deck, "mpm.order", method.order);
  method.kernel = word_or(deck, "mpm.kernel", method.kernel);
  method.transfer = word_or(deck, "mpm.transfer", method.transfer);
  method.gas_energy = word_or(deck, "mpm.energy", method.gas_energy);
  method.contact = word_or(deck, "mpm.contact", method.contact);
  method.criterion = deck.integer("mpm.criterion");
  method.membrane_strain = word_or(deck, "membrane.strain", method.membrane_strain);
  method.normals = word_or(deck, "membrane.normals", method.normals);
  method.matrix = word_or(deck, "membrane.matrix", method.matrix);
  method.lone_point = word_or(deck, "membrane.alone", method.lone_point);
  if (deck.given("mpm.ledger")) method.ledger = deck.logical("mpm.ledger");
  method.jaumann = deck.logical("mpm.jaumann");
  drop_what_lacks_its_ground(deck, method);
  check(deck, method, diagnostics);
  return method;
}

}  // namespace tether
