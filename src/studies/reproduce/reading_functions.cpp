// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/reading_functions.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/numbers.hpp"
#include "results/signal.hpp"
#include "studies/reproduce/point_readings.hpp"

namespace tether::published {
namespace {

using Arguments = std::vector<Argument>;
using enum ArgumentKind;

const std::string& word_of(const Argument& argument) { return std::get<std::string>(argument); }
double number_of(const RunFiles& run, const Argument& argument) {
  return std::get<std::shared_ptr<const Formula>>(argument)->of_run(run);
}
Numbers column_of(const RunFiles& run, const Argument& argument) { return run.column(word_of(argument)); }

std::size_t least(const Numbers& values) {
  return static_cast<std::size_t>(std::min_element(values.begin(), values.end()) - values.begin());
}
std::size_t largest(const Numbers& values) {
  return static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
}

double first_of(const RunFiles& run, const Arguments& a) { return column_of(run, a[0]).front(); }
double last_of(const RunFiles& run, const Arguments& a) { return column_of(run, a[0]).back(); }
double min_of(const RunFiles& run, const Arguments& a) {
  const Numbers records = column_of(run, a[0]);
  return records[least(records)];
}
double max_of(const RunFiles& run, const Arguments& a) {
  const Numbers records = column_of(run, a[0]);
  return records[largest(records)];
}
double time_of_min(const RunFiles& run, const Arguments& a) { return run.column("time")[least(column_of(run, a[0]))]; }
double time_of_max(const RunFiles& run, const Arguments& a) {
  return run.column("time")[largest(column_of(run, a[0]))];
}

double mean_after(const RunFiles& run, const Arguments& a) {
  const Numbers time = run.column("time"), records = column_of(run, a[0]);
  const double from = number_of(run, a[1]);
  Numbers since;
  for (std::size_t k = 0; k < time.size(); ++k) {
    if (time[k] > from) since.push_back(records[k]);
  }
  return mean(since);
}

double settles(const RunFiles& run, const Arguments& a) {
  const Numbers time = run.column("time"), records = column_of(run, a[0]);
  const double band = number_of(run, a[1]);
  std::size_t record = 0;
  while (std::abs(records[record] - records.back()) > band) ++record;
  return time[record];
}

/// Returns how far it comes back: what swings from one side to the other and back returns to its first extreme on the
/// side where it began.
double returns_to(const RunFiles& run, const Arguments& a) {
  const Numbers time = run.column("time");
  Numbers records = column_of(run, a[0]);
  const double side = records.front() < 0 ? -1 : 1;
  for (double& value : records) value *= side;
  return side * first_maximum_after(time, records, first_minimum(time, records).time).value;
}

/// Twice the mean time between passages through a level.
double period_of(const RunFiles& run, const Arguments& a) {
  return period_about(run.column("time"), column_of(run, a[0]), number_of(run, a[1]));
}

double snapshot_time(const RunFiles& run, const Arguments& a) { return run.time(snapshot_of(run.snapshots(), a[0])); }
double deck_value(const RunFiles& run, const Arguments& a) { return run.deck_value(word_of(a[0])); }
double of_scene(const RunFiles& run, const Arguments& a) {
  try {
    return scene_value(run.scene(), word_of(a[0]));
  } catch (const std::domain_error&) {
    return no_number;  // the scene has no such solution
  }
}
double modulus(const RunFiles& run, const Arguments& a) {
  const double body = number_of(run, a[0]);
  return std::isnan(body) ? no_number : modulus_of(run.scene(), static_cast<int>(body));
}
double summary(const RunFiles& run, const Arguments& a) { return run.summary(word_of(a[0])); }
double outcome(const RunFiles& run, const Arguments& a) { return run.outcome(word_of(a[0])); }
double of_reference(const RunFiles& run, const Arguments& a) { return number_of(run.reference(), a[0]); }

const std::vector<ReadingFunction> functions{
    {"first", {column}, false, "first(column) is the first record of a column of the history.", first_of},
    {"last", {column}, false, "last(column) is the last record.", last_of},
    {"min", {column}, false, "min(column) is the least record.", min_of},
    {"max", {column}, false, "max(column) is the largest record.", max_of},
    {"time_of_min", {column}, false, "time_of_min(column) is the time of the first least record.", time_of_min},
    {"time_of_max", {column}, false, "time_of_max(column) is the time of the first largest record.", time_of_max},
    {"mean_after",
     {column, number},
     false,
     "mean_after(column, t) is the mean of the records after the time t.",
     mean_after},
    {"settles",
     {column, number},
     false,
     "settles(column, band) is the first time at which the column is as near to its last record as the band.",
     settles},
    {"returns_to",
     {column},
     false,
     "returns_to(column) is the extreme of a swing when it is back on the side where it began.",
     returns_to},
    {"period",
     {column, number},
     false,
     "period(column, level) is twice the mean time between the column's passages through the level.",
     period_of},
    {"points_sum",
     {of_each, of_each, snapshot},
     false,
     "points_sum(f, which, snapshot) is the sum of f over the points for which `which` is not 0; both are expressions "
     "of the fields of particles.nc, the snapshot is first, last, or a number from 0.",
     points_sum},
    {"points_mean",
     {of_each, of_each, snapshot},
     false,
     "points_mean(f, which, snapshot) is the mean of f.",
     points_mean},
    {"points_min", {of_each, of_each, snapshot}, false, "points_min(f, which, snapshot) is the least f.", points_min},
    {"points_max", {of_each, of_each, snapshot}, false, "points_max(f, which, snapshot) is the largest f.", points_max},
    {"points_where_least",
     {of_each, of_each, of_each, snapshot},
     false,
     "points_where_least(f, g, which, snapshot) is f at the point where g is least.",
     points_where_least},
    {"point", {of_each, number, snapshot}, false, "point(f, k, snapshot) is f at point k, from 1.", point},
    {"nodes_sum",
     {of_each, of_each, snapshot},
     false,
     "nodes_sum(f, which, snapshot) is the same over the nodes of mesh.nc, whose places are x and y.",
     nodes_sum},
    {"nodes_mean",
     {of_each, of_each, snapshot},
     false,
     "nodes_mean(f, which, snapshot) is the mean of f over nodes.",
     nodes_mean},
    {"nodes_min",
     {of_each, of_each, snapshot},
     false,
     "nodes_min(f, which, snapshot) is the least f of nodes.",
     nodes_min},
    {"nodes_max",
     {of_each, of_each, snapshot},
     false,
     "nodes_max(f, which, snapshot) is the largest f of nodes.",
     nodes_max},
    {"columns_mean",
     {word, number, number, snapshot},
     false,
     "columns_mean(field, a, b, snapshot) is the mean, over columns of cells between x = a and b, of their points' "
     "mean.",
     columns_mean},
    {"front",
     {word, number, snapshot},
     false,
     "front(field, level, snapshot) is where the columns' means, seen from the right end, first pass the level.",
     front},
    {"columns_apart",
     {word},
     false,
     "columns_apart(field) is the largest difference of the columns' means, at the end, from the run that it is "
     "compared with.",
     columns_apart},
    {"thickness",
     {number},
     false,
     "thickness(body) is the volume of a body's line of points over its length, at the start.",
     thickness},
    {"thickness_about_axis",
     {number},
     false,
     "thickness_about_axis(body) is the volume of a body's line of points over the surface that it turns through.",
     thickness_about_axis},
    {"snapshot_time", {snapshot}, false, "snapshot_time(snapshot) is its time.", snapshot_time},
    {"deck", {word}, true, "deck(group.name(i,j)) is a number of the deck that ran.", deck_value},
    {"scene", {solution}, true, "scene(name) is a number that follows from the scene by an exact solution.", of_scene},
    {"modulus",
     {number},
     true,
     "modulus(body) is Young's modulus, the bulk modulus of a fluid, the specific energy of a gas.",
     modulus},
    {"summary", {word}, false, "summary(key) is the key of summary.txt where names are fields.", summary},
    {"outcome", {word}, false, "outcome(name) is what a bisection found: outcome(largest_holding).", outcome},
    {"reference", {number}, false, "reference(f) is f of the run that this one is compared with.", of_reference},
};

}  // namespace

std::span<const ReadingFunction> reading_functions() { return functions; }

const ReadingFunction* find_reading_function(const std::string& name) {
  const auto found = std::find_if(functions.begin(), functions.end(),
                                  [&](const ReadingFunction& function) { return function.name == name; });
  return found == functions.end() ? nullptr : &*found;
}

}  // namespace tether::published
