// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "studies/reproduce_problems.hpp"
#include "studies/reproduce_readings.hpp"

namespace tether::published {
namespace {

// The airbag and the probe: 6.3, Tables 7 and 8, Boxes 10 and 11, in SI units. Gas is bodies 1 and 2, the probe body 3,
// the bag body 4. About an axis: masses are whole ones.

constexpr int probe = 3, bag = 4;
constexpr double bag_thickness = 0.5e-3, bag_density = 662, bag_mass = 0.3672;
constexpr double half_width = 0.290, half_height = 0.1575;  // of the ellipsoid of 580 x 315 mm

/// Surface of the ellipsoid of revolution: 2 pi a^2 (1 + (1 - e^2)/e artanh e), e^2 = 1 - c^2/a^2.
double bag_surface() {
  const double e = std::sqrt(1 - half_height * half_height / (half_width * half_width));
  return 2 * std::numbers::pi * half_width * half_width * (1 + (1 - e * e) / e * std::atanh(e));
}

double cylinder(double density, double radius, double height) {
  return density * std::numbers::pi * radius * radius * height;
}

double probe_mass(const RunFiles& run) { return run.history("body_mass", probe).front(); }
double bag_grams(const RunFiles& run) { return 1e3 * run.history("body_mass", bag).front(); }

/// The volume of the points between the ends over the surface that they stand for [mm].
double bag_millimetres(const RunFiles& run) {
  const auto x = run.points("x", 0, bag), y = run.points("y", 0, bag), volume = run.points("volume", 0, bag);
  double surface = 0, between = 0;
  for (std::size_t p = 1; p + 1 < x.size(); ++p) {
    const double piece = std::hypot(x[p + 1] - x[p], y[p + 1] - y[p]) + std::hypot(x[p] - x[p - 1], y[p] - y[p - 1]);
    surface += 2 * std::numbers::pi * x[p] * piece / 2;
    between += volume[p];
  }
  return 1e3 * between / surface;
}

double first_pressure(const RunFiles& run) { return mean(run.points("pressure", 0, 1)); }

double gas_points(const RunFiles& run) {
  return static_cast<double>(run.points("x", 0, 1).size() + run.points("x", 0, 2).size());
}

/// How far the probe sinks, in mm, and when it is lowest, in ms.
struct Sinking {
  double depth = 0, time = 0;

  explicit Sinking(const RunFiles& run) {
    const auto times = run.history("time"), y = run.history("body_y", probe);
    const auto lowest = std::min_element(y.begin(), y.end());
    depth = 1e3 * (y.front() - *lowest);
    time = 1e3 * times[static_cast<std::size_t>(lowest - y.begin())];
  }
};

double peak(const RunFiles& run) { return Sinking(run).depth; }
double peak_time(const RunFiles& run) { return Sinking(run).time; }
double further_than_beside(const RunFiles& run) { return peak(run) - peak(run.beside()); }

/// What Tables 7 and 8 say; the box's cells cut the cylinder's edges, and the bag's mass is no other's. `by` are the
/// methods that come to an end, and are judged.
std::vector<Quantity> of_probe_and_bag(std::vector<Printed> probe_masses, Judged by) {
  const double thicker = bag_mass / (bag_density * bag_surface());
  return {{.name = "mass of the probe [kg]",
           .reading = probe_mass,
           .published = std::move(probe_masses),
           .by_published = by},
          {.name = "mass of the bag [g]",
           .reading = bag_grams,
           .published = {printed("367.2", "6.3.1"),
                         following(1e3 * bag_thickness * bag_density * bag_surface(), "Table 8 on 580 x 315 mm", 0.06)},
           .by_published = by},
          {.name = "thickness of the bag [mm]",
           .reading = bag_millimetres,
           .published = {printed("0.5", "Table 8"), following(1e3 * thicker, "367.2 g on 580 x 315 mm", 0.03)},
           .by_published = by},
          {.name = "pressure at t = 0 [Pa]",
           .reading = first_pressure,
           .published = {following(4000, "Table 8", 0.01)},
           .by_published = by},
          stated_modulus("Young's modulus of the bag [Pa]", bag, 6e7, "Table 8"),
          stated_modulus("Young's modulus of the probe [Pa]", probe, 5e7, "6.3.1"),
          {.name = "specific energy of the gas [J/kg]",
           .reading = modulus(1),
           .of_deck = true,
           .published = {printed("8226", "Table 8")},
           .by_published = Judged::both},
          {.name = "largest displacement of the probe [mm]", .reading = peak},
          {.name = "its time [ms]", .reading = peak_time}};
}

}  // namespace

std::vector<Problem> airbags() {
  const auto box_mass = [](double mass, const char* box) { return following(mass, box, 0.03); };
  Problem small{.name = "cyl-200", .place = "6.3.2, Fig. 60", .deck = "cyl-200"};
  small.quantities =
      of_probe_and_bag({printed("6.03", "Table 7"), box_mass(cylinder(2375, 0.1, 0.08), "Box 10")}, Judged::robust);
  small.quantities.push_back({.name = "gas points",
                              .reading = gas_points,
                              .published = {following(3000, "6.3.2: approximately", 0.2)},
                              .by_published = Judged::robust});
  Problem tethered{.name = "cyl-200-tether-kept", .place = "6.3.2", .deck = "cyl-200-tether-kept", .beside = "cyl-200"};
  tethered.quantities = {{.name = "further than without the tether [mm]",
                          .reading = further_than_beside,
                          .published = {printed("20", "6.3.2: about")}},
                         stated_modulus("Young's modulus of the bag [Pa]", bag, 6e7, "Table 8"),
                         {.name = "specific energy of the gas [J/kg]",
                          .reading = modulus(1),
                          .of_deck = true,
                          .published = {printed("8226", "Table 8")},
                          .by_published = Judged::both}};
  Problem large{.name = "cyl-500", .place = "6.3.3, Fig. 63", .deck = "cyl-500"};
  large.quantities =
      of_probe_and_bag({printed("8.05", "Table 7"), box_mass(cylinder(360, 0.25, 0.08), "Box 11")}, Judged::both);
  return {std::move(small), std::move(tethered), std::move(large)};
}

}  // namespace tether::published
