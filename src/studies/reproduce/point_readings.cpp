// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/point_readings.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "base/diagnostics.hpp"
#include "base/numbers.hpp"
#include "reference/hung_string.hpp"
#include "reference/riemann.hpp"

namespace tether::published {
namespace {

using Arguments = std::vector<Argument>;

const Formula& formula_of(const Argument& argument) { return *std::get<std::shared_ptr<const Formula>>(argument); }

double sum(const Numbers& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

double least_of(const Numbers& values) {
  return values.empty() ? no_number : *std::min_element(values.begin(), values.end());
}
double largest_of(const Numbers& values) {
  return values.empty() ? no_number : *std::max_element(values.begin(), values.end());
}

/// The values of a formula at all points of a snapshot, or at all nodes.
Numbers at_points(const RunFiles& run, const Formula& formula, std::size_t snapshot) {
  std::vector<Numbers> fields;
  for (const std::string& name : formula.names()) fields.push_back(run.points(name, snapshot));
  return formula.of_each(run, fields, fields.empty() ? run.points("x", snapshot).size() : fields.front().size());
}
Numbers at_nodes(const RunFiles& run, const Formula& formula, std::size_t snapshot) {
  std::vector<Numbers> fields;
  for (const std::string& name : formula.names()) fields.push_back(run.nodes(name, snapshot));
  return formula.of_each(run, fields, fields.empty() ? run.nodes("x", snapshot).size() : fields.front().size());
}

/// Returns of the values those for which `which` is not 0.
Numbers selected(const Numbers& values, const Numbers& which) {
  Numbers chosen;
  for (std::size_t p = 0; p < values.size(); ++p) {
    if (which.at(p) != 0) chosen.push_back(values[p]);
  }
  return chosen;
}

Numbers chosen_points(const RunFiles& run, const Argument& value, const Argument& which, const Argument& snapshot) {
  const std::size_t k = snapshot_of(run.snapshots(), snapshot);
  return selected(at_points(run, formula_of(value), k), at_points(run, formula_of(which), k));
}
Numbers chosen_nodes(const RunFiles& run, const Arguments& a) {
  const std::size_t k = snapshot_of(run.node_snapshots(), a[2]);
  return selected(at_nodes(run, formula_of(a[0]), k), at_nodes(run, formula_of(a[1]), k));
}

/// Middles of the columns of cells that hold points, and the means of a field over their points.
struct Columns {
  Numbers x, mean_of_points;

  Columns(const RunFiles& run, const std::string& field, std::size_t snapshot) {
    const Numbers places = run.points("x", snapshot), values = run.points(field, snapshot);
    const double width = run.summary("dx");
    std::map<double, Numbers> columns;  // by their middles
    for (std::size_t p = 0; p < places.size(); ++p)
      columns[(std::floor(places[p] / width) + 0.5) * width].push_back(values[p]);
    for (const auto& [middle, of_column] : columns) x.push_back(middle), mean_of_points.push_back(mean(of_column));
  }
};

/// A body's points at the start as a line.
struct Line {
  Numbers x, y, volume;

  Line(const RunFiles& run, const Argument& body) {
    const auto number = static_cast<int>(formula_of(body).of_run(run));
    x = run.points("x", 0, number), y = run.points("y", 0, number), volume = run.points("volume", 0, number);
  }
  double piece(std::size_t p) const { return std::hypot(x[p] - x[p - 1], y[p] - y[p - 1]); }
  double volume_between_ends() const {
    double between = 0;
    for (std::size_t p = 1; p + 1 < volume.size(); ++p) between += volume[p];
    return between;
  }
};

}  // namespace

std::size_t snapshot_of(std::size_t count, const Argument& argument) {
  const auto& word = std::get<std::string>(argument);
  if (count > 0 && word == "first") return 0;
  if (count > 0 && word == "last") return count - 1;
  const auto number = parse_integer(word);
  if (!number || *number < 0 || static_cast<std::size_t>(*number) >= count)
    throw FileError(fmt::format("there is no snapshot {}, of {}", word, count));
  return static_cast<std::size_t>(*number);
}

double mean(const Numbers& values) {
  return values.empty() ? no_number : sum(values) / static_cast<double>(values.size());
}

double points_sum(const RunFiles& run, const Arguments& a) { return sum(chosen_points(run, a[0], a[1], a[2])); }
double points_mean(const RunFiles& run, const Arguments& a) { return mean(chosen_points(run, a[0], a[1], a[2])); }
double points_min(const RunFiles& run, const Arguments& a) { return least_of(chosen_points(run, a[0], a[1], a[2])); }
double points_max(const RunFiles& run, const Arguments& a) { return largest_of(chosen_points(run, a[0], a[1], a[2])); }
double points_where_least(const RunFiles& run, const Arguments& a) {
  const Numbers values = chosen_points(run, a[0], a[2], a[3]), by = chosen_points(run, a[1], a[2], a[3]);
  if (values.empty()) return no_number;
  return values[static_cast<std::size_t>(std::min_element(by.begin(), by.end()) - by.begin())];
}
double point(const RunFiles& run, const Arguments& a) {
  const Numbers values = at_points(run, formula_of(a[0]), snapshot_of(run.snapshots(), a[2]));
  const double k = formula_of(a[1]).of_run(run);
  return k >= 1 && k <= static_cast<double>(values.size()) ? values[static_cast<std::size_t>(k) - 1] : no_number;
}
double nodes_sum(const RunFiles& run, const Arguments& a) { return sum(chosen_nodes(run, a)); }
double nodes_mean(const RunFiles& run, const Arguments& a) { return mean(chosen_nodes(run, a)); }
double nodes_min(const RunFiles& run, const Arguments& a) { return least_of(chosen_nodes(run, a)); }
double nodes_max(const RunFiles& run, const Arguments& a) { return largest_of(chosen_nodes(run, a)); }

double columns_mean(const RunFiles& run, const Arguments& a) {
  const Columns columns(run, std::get<std::string>(a[0]), snapshot_of(run.snapshots(), a[3]));
  const double from = formula_of(a[1]).of_run(run), to = formula_of(a[2]).of_run(run);
  Numbers between;
  for (std::size_t c = 0; c < columns.x.size(); ++c) {
    if (columns.x[c] > from && columns.x[c] < to) between.push_back(columns.mean_of_points[c]);
  }
  return mean(between);
}

double front(const RunFiles& run, const Arguments& a) {
  const Columns columns(run, std::get<std::string>(a[0]), snapshot_of(run.snapshots(), a[2]));
  const double level = formula_of(a[1]).of_run(run);
  for (std::size_t c = columns.x.size(); c-- > 1;) {
    const double here = columns.mean_of_points[c - 1], right = columns.mean_of_points[c];
    if (here < level) continue;
    return columns.x[c - 1] + (columns.x[c] - columns.x[c - 1]) * (here - level) / (here - right);
  }
  return no_number;
}

double columns_apart(const RunFiles& run, const Arguments& a) {
  const auto columns = [&](const RunFiles& of) {
    return Columns(of, std::get<std::string>(a[0]), of.snapshots() - 1).mean_of_points;
  };
  const Numbers here = columns(run), there = columns(run.reference());
  double largest = 0;
  for (std::size_t c = 0; c < std::min(here.size(), there.size()); ++c)
    largest = std::max(largest, std::abs(here[c] - there[c]));
  return largest;
}

double thickness(const RunFiles& run, const Arguments& a) {
  const Line line(run, a[0]);
  double length = 0;
  for (std::size_t p = 1; p < line.x.size(); ++p) length += line.piece(p);
  const auto pieces = static_cast<double>(line.x.size() - 1);
  return line.volume_between_ends() / (length * (pieces - 1) / pieces);
}

double thickness_about_axis(const RunFiles& run, const Arguments& a) {
  const Line line(run, a[0]);
  double surface = 0;
  for (std::size_t p = 1; p + 1 < line.x.size(); ++p)
    surface += 2 * std::numbers::pi * line.x[p] * (line.piece(p + 1) + line.piece(p)) / 2;
  return line.volume_between_ends() / surface;
}

namespace {

struct SceneValue {
  const char* name;
  double (*of)(const Scene& scene);
};

RiemannSolution tube(const Scene& scene) { return riemann_tube(scene).solution; }

/// Mass through the shock: rho1 s = rho2 (s - u).
double shock_speed(const Scene& scene) {
  const RiemannSolution solution = tube(scene);
  const StarRegion& star = solution.star;
  return star.density_right * star.velocity / (star.density_right - solution.problem.right.density);
}

/// E A over what is between a string's first and last point, as 5.5.2 of the thesis counts it.
double stiffness_between_points(const Scene& scene) {
  const HungString string = hung_string(scene);
  const PointSet& P = scene.points;
  return string.stiffness * string.length / std::hypot(P.x.back() - P.x.front(), P.y.back() - P.y.front());
}

/// E A over what is between the wall and the fluid, the spring's length in Fig. 45 of the thesis.
double stiffness_beyond_fluid(const Scene& scene) {
  const Piston piston = piston_of(scene);
  return piston.spring_stiffness * hung_string(scene).length / (scene.grid.y1 - scene.grid.y0 - piston.fluid_length);
}

double period_without_fluid(const Scene& scene) {
  const Piston piston = piston_of(scene);
  return 2 * std::numbers::pi * std::sqrt(piston.mass / piston.spring_stiffness);
}

constexpr std::array values{
    SceneValue{"shock_speed", shock_speed},
    SceneValue{"contact_speed", [](const Scene& scene) { return tube(scene).star.velocity; }},
    SceneValue{"shocked_density", [](const Scene& scene) { return tube(scene).star.density_right; }},
    SceneValue{"shocked_pressure", [](const Scene& scene) { return tube(scene).star.pressure; }},
    SceneValue{"right_density", [](const Scene& scene) { return tube(scene).problem.right.density; }},
    SceneValue{"right_pressure", [](const Scene& scene) { return tube(scene).problem.right.pressure; }},
    SceneValue{"diaphragm", [](const Scene& scene) { return tube(scene).problem.diaphragm; }},
    SceneValue{"string_slack", [](const Scene& scene) { return hung_string(scene).slack; }},
    SceneValue{"string_stiffness", stiffness_between_points},
    SceneValue{"piston_stiffness", stiffness_beyond_fluid},
    SceneValue{"piston_period", [](const Scene& scene) { return piston_of(scene).period(); }},
    SceneValue{"piston_frequency", [](const Scene& scene) { return piston_of(scene).frequency(); }},
    SceneValue{"piston_period_without_fluid", period_without_fluid},
};

struct Modulus {
  const Body& body;
  double operator()(const PlaneElastic& law) const { return law.E; }
  double operator()(const FiniteElastic& law) const { return law.E; }
  double operator()(const Membrane& law) const { return law.E; }
  double operator()(const LinearFluid& law) const { return law.beta; }
  double operator()(const IdealGas&) const { return body.specific_energy; }
};

}  // namespace

std::vector<std::string> scene_value_names() {
  std::vector<std::string> names;
  for (const SceneValue& value : values) names.emplace_back(value.name);
  return names;
}

double scene_value(const Scene& scene, const std::string& name) {
  if (scene.points.size() == 0) throw std::domain_error("a scene without material points has no such solution");
  for (const SceneValue& value : values) {
    if (name == value.name) return value.of(scene);
  }
  throw std::out_of_range(name);
}

double modulus_of(const Scene& scene, int body) {
  if (body < 1 || static_cast<std::size_t>(body) > scene.bodies.size()) return std::numeric_limits<double>::quiet_NaN();
  const Body& it = scene.bodies[static_cast<std::size_t>(body) - 1];
  return std::visit(Modulus{it}, it.material);
}

}  // namespace tether::published
