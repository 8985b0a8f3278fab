// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce_readings.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "base/numbers.hpp"

namespace tether::published {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct Modulus {
  const Body& body;
  double operator()(const PlaneElastic& law) const { return law.E; }
  double operator()(const Membrane& law) const { return law.E; }
  double operator()(const LinearFluid& law) const { return law.beta; }
  double operator()(const IdealGas&) const { return body.specific_energy; }
};

}  // namespace

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

double mean(const std::vector<double>& values) {
  return values.empty() ? none : sum(values) / static_cast<double>(values.size());
}

Printed printed(const std::string& digits, const std::string& place) {
  const auto exponent = digits.find_first_of("eE");
  const std::string mantissa = digits.substr(0, exponent);
  const auto point = mantissa.find('.');
  const double decimals = point == std::string::npos ? 0 : static_cast<double>(mantissa.size() - point - 1);
  const double power = exponent == std::string::npos ? 0 : parse_real(digits.substr(exponent + 1)).value();
  return {parse_real(digits).value(), place, 0.5 * std::pow(10.0, power - decimals)};
}

Printed following(double value, const std::string& place, double part) {
  return {value, place, part * std::abs(value)};
}

Printed stated(double value, const std::string& place) { return following(value, place, 1e-6); }

Readout constant(double value) {
  return [value](const RunFiles&) { return value; };
}

Readout modulus(int body) {
  return [body](const RunFiles& run) {
    const Body& it = run.scene().bodies.at(static_cast<std::size_t>(body) - 1);
    return std::visit(Modulus{it}, it.material);
  };
}

Quantity stated_modulus(const std::string& name, int body, double value, const std::string& place) {
  return {.name = name,
          .reading = modulus(body),
          .of_deck = true,
          .published = {stated(value, place)},
          .by_published = Judged::both};
}

Readout summary_value(const std::string& key) {
  return [key](const RunFiles& run) { return run.summary(key); };
}

Readout first_value(const std::string& quantity, std::size_t k) {
  return [quantity, k](const RunFiles& run) { return run.history(quantity, k).front(); };
}

Readout last_value(const std::string& quantity, std::size_t k) {
  return [quantity, k](const RunFiles& run) { return run.history(quantity, k).back(); };
}

double energy_lost_percent(const RunFiles& run) {
  const auto total = run.history("energy_total");
  return 100 * (total.front() - total.back()) / total.front();
}

double first_near_the_end(const RunFiles& run, const std::string& quantity, std::size_t k, double band) {
  const auto time = run.history("time"), values = run.history(quantity, k);
  std::size_t record = 0;
  while (std::abs(values[record] - values.back()) > band) ++record;
  return time[record];
}

ColumnMeans column_means(const RunFiles& run, const std::string& field) {
  const std::size_t last = run.snapshots() - 1;
  const auto x = run.points("x", last), values = run.points(field, last);
  const double width = run.summary("dx");
  std::map<double, std::vector<double>> columns;  // by their middles
  for (std::size_t p = 0; p < x.size(); ++p) columns[(std::floor(x[p] / width) + 0.5) * width].push_back(values[p]);
  ColumnMeans means;
  for (const auto& [middle, of_column] : columns) {
    means.x.push_back(middle);
    means.mean.push_back(mean(of_column));
  }
  return means;
}

Readout thickness(int body) {
  return [body](const RunFiles& run) {
    const auto x = run.points("x", 0, body), y = run.points("y", 0, body), volume = run.points("volume", 0, body);
    double length = 0, between = 0;  // a point between two others stands for half of the way to either
    for (std::size_t p = 1; p < x.size(); ++p) length += std::hypot(x[p] - x[p - 1], y[p] - y[p - 1]);
    for (std::size_t p = 1; p + 1 < volume.size(); ++p) between += volume[p];
    const auto pieces = static_cast<double>(x.size() - 1);
    return between / (length * (pieces - 1) / pieces);
  };
}

Readout count_of(int body) {
  return [body](const RunFiles& run) { return static_cast<double>(run.points("x", 0, body).size()); };
}

}  // namespace tether::published
