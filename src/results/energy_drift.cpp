// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/energy_drift.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tether {
namespace {

double largest_change(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value - values.front()));
  return largest;
}

/// Whether what the method lost, too, is put back into a balance.
enum class Losses { put_back, left_out };

/// The total energy less what came from outside, and with what went out and what the method lost.
std::vector<double> balance(const History& history, Losses losses) {
  auto total = history.column("energy_total");
  for (const Quantity& quantity : history.layout.quantities) {
    const double sign = sign_of(quantity.book);
    if (sign == 0 || (quantity.book == Book::lost && losses == Losses::left_out)) continue;
    const auto values = history.column(quantity.name);
    for (std::size_t k = 0; k < total.size(); ++k) total[k] += sign * values[k];
  }
  return total;
}

/// Largest size of a column of these energies at any time; 0 where there is none.
double largest_of(const History& history, const std::string& name) {
  double largest = 0;
  for (const Quantity& quantity : history.layout.quantities) {
    if (quantity.name != name) continue;
    for (const double value : history.column(name)) largest = std::max(largest, std::abs(value));
  }
  return largest;
}

/// Part of the energy below which what seems exchanged is rounding.
constexpr double rounding = 1e-12;

/// Returns what the method itself lost since the start, by record. Its columns may be large and of opposite signs.
std::vector<double> lost_by_method(const History& history) {
  std::vector<double> lost(history.records.size(), 0.0);
  for (const Quantity& quantity : history.layout.quantities) {
    if (quantity.book != Book::lost) continue;
    const auto values = history.column(quantity.name);
    for (std::size_t k = 0; k < lost.size(); ++k) lost[k] += values[k];
  }
  return lost;
}

/// The largest change of one of the energies, of what was booked, or of all that the method lost. Within a free rigid
/// body, or a fluid at rest, none is exchanged: then the energy itself that is there, of a fluid in a box its pressure
/// times its volume.
double exchanged_energy(const History& history) {
  double exchanged = history.records.empty() ? 0 : largest_change(lost_by_method(history)), there = 0;
  for (const Quantity& quantity : history.layout.quantities) {
    if (quantity.book != Book::gained && quantity.book != Book::given) continue;
    exchanged = std::max(exchanged, largest_change(history.column(quantity.name)));
  }
  for (const char* kind : {"energy_kinetic", "energy_strain", "energy_internal", "energy_potential"}) {
    const auto values = history.column(kind);
    exchanged = std::max(exchanged, largest_change(values));
    for (const double value : values) there = std::max(there, std::abs(value));
  }
  there = std::max(there, largest_of(history, "energy_pressure"));
  const double of = exchanged > rounding * there ? exchanged : there;
  return of > history.layout.rounding_energy ? of : 0;
}

}  // namespace

double sign_of(Book book) {
  switch (book) {
    case Book::gained:
      return -1;
    case Book::given:
    case Book::lost:
      return 1;
    case Book::none:
      break;
  }
  return 0;
}

double energy_drift(const History& history) {
  const double exchanged = exchanged_energy(history);
  return exchanged > 0 ? largest_change(balance(history, Losses::put_back)) / exchanged : 0;
}

double energy_rise(const History& history) {
  const double exchanged = std::max(exchanged_energy(history), settling * largest_of(history, "energy_pressure"));
  const auto total = balance(history, Losses::left_out);
  return exchanged > 0 ? (*std::max_element(total.begin(), total.end()) - total.front()) / exchanged : 0;
}

double energy_lost(const History& history) {
  const double exchanged = exchanged_energy(history);
  return exchanged > 0 ? lost_by_method(history).back() / exchanged : 0;
}

double energy_lost_by(const History& history, std::initializer_list<std::string_view> columns) {
  const double exchanged = exchanged_energy(history);
  double lost = 0;
  for (const Quantity& quantity : history.layout.quantities) {
    if (std::ranges::find(columns, quantity.name) != columns.end()) lost += history.column(quantity.name).back();
  }
  return exchanged > 0 ? lost / exchanged : 0;
}

double energy_growth(const History& history) {
  double largest = 0, gained = 0;
  const auto total = history.column("energy_total");
  for (const double value : total) largest = std::max(largest, std::abs(value));
  for (const Quantity& quantity : history.layout.quantities) {
    if (quantity.book == Book::gained) gained = std::max(gained, largest_change(history.column(quantity.name)));
  }
  const double start = std::abs(total.front());
  return start > rounding * gained ? largest / start : std::numeric_limits<double>::quiet_NaN();
}

double mass_drift(const History& history) {
  auto mass = history.column("mass");
  const double there = mass.front();
  for (const Quantity& quantity : history.layout.quantities) {
    const bool in = quantity.name == "edge_mass_in";
    if (!in && quantity.name != "edge_mass_out") continue;
    const auto passed = history.column(quantity.name);
    for (std::size_t k = 0; k < mass.size(); ++k) mass[k] += in ? -passed[k] : passed[k];
  }
  return largest_change(mass) / there;
}

}  // namespace tether
