// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "base/diagnostics.hpp"
#include "model/coupled.hpp"
#include "model/solids.hpp"
#include "results/energy_drift.hpp"
#include "run/summary.hpp"

namespace tether {
namespace {

/// Why a body's volume changes beyond reason.
const char* cause_of_volume(const Scene& scene) {
  if (scene.flow() || scene.coupled()) return "a body too soft for what acts on it, or a fluid that goes through it";
  const auto is_linear = [](const SolidRegion& region) { return std::holds_alternative<LinearElastic>(region.law); };
  if (scene.solids() && std::ranges::any_of(scene.solids()->regions, is_linear))
    return "a body too soft for what acts on it: large turns by law='linear' grow it, which other laws do not";
  if (scene.solids() && scene.solids()->integrator == Integrator::equilibrium)
    return "a body too soft for what acts on it, or steps of the load too long: shorter tstep";
  return "a body too soft for what acts on it";
}

/// Why the energy rises. Steps of boxes that keep it bear more.
const char* cause_of_rise(const Scene& scene) {
  const Coupled* box = scene.coupled();
  const bool linear = box != nullptr && scene.solids() != nullptr && box->coupling.balances_power() &&
                      !keeps_energy(*box, *scene.solids(), scene.clock.tstep);
  return linear ? "steps too long, for which step='energy' of $coupled may do, or a way of coupling that does not hold"
                : "steps too long, or a way of coupling that does not hold";
}

/// Columns by this name, or of bodies by it and a number.
std::vector<std::size_t> columns_of(const HistoryLayout& layout, const std::string& name) {
  const auto names = layout.column_names();
  std::vector<std::size_t> columns;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (names[k] == name || (names[k].starts_with(name + "_") &&
                             names[k].find_first_not_of("0123456789", name.size() + 1) == std::string::npos))
      columns.push_back(k);
  }
  return columns;
}

/// A gas of points: its volume is no sign of anything wrong. Membranes of points keep the one that they have.
bool changes_freely(const Scene& scene, std::size_t body) {
  if (scene.path() != Path::mpm || body >= scene.bodies.size()) return false;
  const Material& material = scene.bodies[body].material;
  return std::holds_alternative<IdealGas>(material) || std::holds_alternative<Membrane>(material);
}

}  // namespace

Watch::Watch(const Scene& scene, const HistoryLayout& layout) : cell_(scene.grid.dx) {
  const Limits& limits = scene.limits;
  const auto names = layout.column_names();
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (names[k] == "mass") mass_ = k;
    if (names[k] == "energy_total") total_ = k;
    if (names[k] == "energy_potential") potential_ = k;
    if (names[k] == "energy_pressure") pressure_ = k;
    for (const char* kind : {"energy_kinetic", "energy_strain", "energy_internal"}) {
      if (names[k] == kind) energies_.push_back(k);
    }
  }
  for (const Quantity& quantity : layout.quantities) {
    // What a method makes is a rise, and no measure of it.
    if (quantity.book != Book::none && quantity.book != Book::lost)
      booked_.push_back({columns_of(layout, quantity.name).front(), sign_of(quantity.book)});
  }
  keeps_books_ = balances_energy(scene, layout);
  const auto add = [&](Number number, const char* column) {
    number.from = columns_of(layout, column);
    if (!number.from.empty()) numbers_.push_back(std::move(number));
  };
  add({.name = "quality",
       .key = SummaryKey("quality_least"),
       .what = "the least volume of an element over that at the start",
       .cause = "a body too soft for what acts on it, or steps too long",
       .limit = limits.quality,
       .failure = Failure::inverts,
       .low = true,
       .worst = 1},
      "element_quality");
  add({.name = "splitting",
       .what = "the mismatch of the power across the interface",
       .cause = "a way of coupling that does not hold: mode='cut-cell' of $coupled does",
       .limit = limits.splitting,
       .failure = Failure::contradicts_energy},
      "interface_mismatch");
  add({.name = "cfl",
       .what = "the number of cells that the fluid crosses in a step",
       .cause = "steps too long for what the fluid carries along, of which much is lost",
       .limit = limits.cfl},
      "cfl");
  volume_ = {.name = "volume",
             .key = SummaryKey("volume_worst"),
             .what = "a body's volume against that at the start, the smaller over the larger,",
             .cause = cause_of_volume(scene),
             .limit = limits.volume,
             .low = true,
             .worst = 1};
  const auto volumes = columns_of(layout, "body_volume");
  for (std::size_t b = 0; b < volumes.size(); ++b) {
    if (changes_freely(scene, b)) continue;
    volume_.from.push_back(volumes[b]), bodies_.push_back(b);
  }
  watch_energy(scene);
}

void Watch::watch_energy(const Scene& scene) {
  const Limits& limits = scene.limits;
  energy_step_ = {.name = "energy_step",
                  .key = SummaryKey("energy_step_largest"),
                  .what = "the rise of the energy in a step that no exchange explains, over the largest energy before,",
                  .cause = cause_of_rise(scene),
                  .limit = limits.energy_step,
                  .failure = Failure::contradicts_energy};
  energy_growth_ = {.name = "energy_growth",
                    .what =
                        "the rise of the energy since the start that no exchange explains, over the energy then or "
                        "exchanged since",
                    .cause = "steps too long, or a run that diverges",
                    .limit = {.stop = limits.energy_growth.stop},  // the run warns of it at its end
                    .failure = Failure::contradicts_energy};
}

void Watch::look(const Record& record, const Solver& solver) {
  if (first_.empty()) first_ = record;
  for (Number& number : numbers_) {
    for (const std::size_t column : number.from) {
      const double value = number.low ? record[column] : std::abs(record[column]);  // turned inside out, it is below 0
      judge(number, value, record.front(), [&] { return number.low ? solver.worst_element() : std::string(); });
    }
  }
  look_at_volumes(record);
  look_at_energy(record);
}

void Watch::look_at_volumes(const Record& record) {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const double ratio = record[volume_.from[k]] / first_[volume_.from[k]];
    judge(volume_, std::min(ratio, 1 / ratio), record.front(), [&] { return fmt::format("body {}", bodies_[k] + 1); });
  }
}

/// Looks at the energy. Its rise is measured by what there was before, and by what was exchanged in the step; its rise
/// since the start by what there was then, and by what was exchanged since.
void Watch::look_at_energy(const Record& record) {
  if (!keeps_books_) return;
  const double balance = kept_energy(record), booked = booked_energy(record);
  if (looked_ && !std::isfinite(balance) && energy_step_.limit.stop > 0)  // the start is the solver's to judge
    throw RunError(
        fmt::format("t = {:.9g}: the energy is no number: likely cause, {}", record.front(), energy_step_.cause));
  const double exchanged = std::abs(record[potential_] - first_[potential_]), rest = rest_energy(record);
  const double measure = std::max({largest_, exchanged, std::abs(booked - booked_before_), rest});
  const auto nowhere = [] { return std::string(); };
  if (measure > 0 && looked_) judge(energy_step_, (balance - balance_) / measure, record.front(), nowhere);
  const double reached = std::max({largest_energy(first_), exchanged, booked, rest});
  if (reached > 0) judge(energy_growth_, (balance - kept_energy(first_)) / reached, record.front(), nowhere);
  looked_ = true;
  balance_ = balance, booked_before_ = booked;
  largest_ = std::max({largest_, largest_energy(record), exchanged, booked});
}

/// The total less what came from outside and with what went out.
double Watch::kept_energy(const Record& record) const {
  double energy = record[total_];
  for (const Term& term : booked_) energy += term.sign * record[term.column];
  return energy;
}

double Watch::booked_energy(const Record& record) const {
  double booked = 0;
  for (const Term& term : booked_) booked += std::abs(record[term.column]);
  return booked;
}

/// Returns the largest energy of the kinds that are no potential.
double Watch::largest_energy(const Record& record) const {
  double largest = 0;
  for (const std::size_t column : energies_) largest = std::max(largest, std::abs(record[column]));
  return largest;
}

/// The kinetic energy of all mass at a speed that is next to rest in a step, or what settles in a fluid that stands.
double Watch::rest_energy(const Record& record) const {
  const double step = record[1];
  const double speed = step > 0 ? resting * cell_ / step : 0;
  const double still = pressure_ == 0 ? 0 : settling * std::abs(record[pressure_]);
  return std::max(0.5 * record[mass_] * speed * speed, still);
}

void Watch::judge(Number& number, double value, double time, const Place& where) {
  const bool worse = number.low ? value < number.worst : value > number.worst;
  if (worse) number.worst = value;
  const auto passes = [&](double limit) { return limit > 0 && (number.low ? value < limit : value > limit); };
  const auto text = [&](double limit) {
    const std::string place = where();
    return fmt::format("{} is {:.3g}{}, {} the limit of {:.3g} ({} of $limits): likely cause, {}", number.what, value,
                       place.empty() ? "" : ", of " + place, number.low ? "below" : "above", limit, number.name,
                       number.cause);
  };
  if (passes(number.limit.stop))
    throw RunError(fmt::format("t = {:.9g}: {}", time, text(number.limit.stop)), number.failure);
  if (number.told || !passes(number.limit.warn)) return;
  number.told = true;
  messages_.push_back(fmt::format("t = {:.6g}: {}", time, text(number.limit.warn)));
}

std::vector<std::string> Watch::take_messages() { return std::exchange(messages_, {}); }

Summary Watch::summary() const {
  Summary summary{line_of(*energy_step_.key, energy_step_.worst)};
  for (const Number& number : numbers_) {
    if (number.key) summary.push_back(line_of(*number.key, number.worst));
  }
  if (!volume_.from.empty()) summary.push_back(line_of(*volume_.key, volume_.worst));
  return summary;
}

std::vector<double> Watch::save() const {
  std::vector<double> saved{looked_ ? 1.0 : 0.0, balance_, largest_, booked_before_};
  const auto add = [&](const Number& number) { saved.insert(saved.end(), {number.worst, number.told ? 1.0 : 0.0}); };
  for (const Number& number : numbers_) add(number);
  add(volume_), add(energy_step_);
  return saved;
}

void Watch::restore(const std::vector<double>& saved, const Record& first) {
  first_ = first;
  looked_ = saved.at(0) != 0, balance_ = saved.at(1), largest_ = saved.at(2), booked_before_ = saved.at(3);
  std::size_t k = 4;
  const auto take = [&](Number& number) { number.worst = saved.at(k), number.told = saved.at(k + 1) != 0, k += 2; };
  for (Number& number : numbers_) take(number);
  take(volume_), take(energy_step_);
}

}  // namespace tether
