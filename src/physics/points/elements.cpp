// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/elements.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "loops/points.hpp"
#include "physics/points/point_laws.hpp"

namespace tether::mpm {

Vec<2> tangent_at(const Points& points, Range string, std::size_t p, bool closed) {
  const std::size_t before = p > string.begin ? p - 1 : closed ? string.end - 1 : p;
  const std::size_t behind = p + 1 < string.end ? p + 1 : closed ? string.begin : p;
  const double dx = points.x[behind] - points.x[before], dy = points.y[behind] - points.y[before];
  const double length = std::sqrt(dx * dx + dy * dy);
  return length > 0 ? Vec<2>{dx / length, dy / length} : Vec<2>{};
}

void stretch_along_tangents(Points& P, Range string, double dt) {
  for_points(string, [&](std::size_t p) {
    P.strain[p] += dt * along({P.dxx[p], P.dyy[p], P.dxy[p]}, {P.tx[p], P.ty[p]});
    P.hoop[p] += dt * P.dzz[p];
  });
}

void turn_tangents(Points& P, Range string, bool closed) {
  for_points(string, [&](std::size_t p) {
    const Vec<2> t = tangent_at(P, string, p, closed);
    if (t[0] == 0 && t[1] == 0) return;
    const double cosine = t[0] * P.tx[p] + t[1] * P.ty[p];
    P.strain[p] *= cosine * cosine;
    P.tx[p] = t[0], P.ty[p] = t[1];
  });
}

namespace {

/// A membrane's end no further than this from a wall that mirrors, in spacings of its points, continues beyond it.
constexpr double reach = 0.75;
/// No further than this it stands on the wall.
constexpr double at_a_wall = 1e-9;

}  // namespace

Elements::Elements(const Scene& scene, std::size_t b, Range range, const Points& points, const Frame& frame)
    : range_(range),
      law_(std::get<Membrane>(scene.bodies[b].material)),
      about_axis_(scene.geometry == Geometry::axisymmetric),
      closed_(scene.bodies[b].closed),
      reference_x_(about_axis_ ? 0 : frame.deck.x0),
      reference_y_(frame.deck.y0) {
  const std::size_t first = range_.begin, last = range_.end - 1;
  for_points(Range{first, last}, [&](std::size_t p) { add(points, p, p + 1, -1, 0); });
  if (closed_) {
    add(points, last, first, -1, 0);
    encloses_ = true;
  } else {
    const bool begins_at_wall = ends_at_wall(points, scene, first, first + 1);
    encloses_ = ends_at_wall(points, scene, last, last - 1) && begins_at_wall;
  }
  for (auto* array : {&energy_, &turn_}) array->assign(elements_.size(), 0.0);
  pull_.assign(elements_.size(), Pair{});
  swept_.assign(elements_.size(), Swept{});
  for (auto* array : {&heat_, &strain_, &hoop_, &tension_, &ring_, &parts_}) array->assign(scene.bodies[b].count, 0.0);
  for (auto* array : {&force_, &place_, &moved_}) array->assign(scene.bodies[b].count, Pair{});
  enclosed_at_start_ = enclosed_volume(points);
  if (encloses_) ambient_ = enclosed_at_start_ < 0 ? -scene.ambient : scene.ambient;
}

/// A point's share of the cross-section is its volume over the depth; of a pinned end it is half a piece, so that the
/// larger one of the two counts.
void Elements::add(const Points& P, std::size_t a, std::size_t b, int mirror, double wall) {
  Element element{a, b, mirror, wall, 0, 0.5 * (P.strain[a] + P.strain[b]), 0, 0};
  const Shape now = shape(P, element);
  const Geometry geometry = about_axis_ ? Geometry::axisymmetric : Geometry::plane;
  element.rest = now.length;
  element.radius = now.radius;
  element.volume = std::max(P.volume[a] / depth(geometry, P.x[a]), P.volume[b] / depth(geometry, P.x[b])) *
                   depth(geometry, now.radius);
  elements_.push_back(element);
}

/// Continues to its image behind a wall that mirrors; an end that stands on a wall, as a pin may, needs none.
bool Elements::ends_at_wall(const Points& P, const Scene& scene, std::size_t end, std::size_t inner) {
  const double spacing = std::hypot(P.x[end] - P.x[inner], P.y[end] - P.y[inner]);
  const BackgroundGrid& grid = scene.grid;
  const auto ends = [&](Wall wall, double distance, int mirror, double place) {
    if (wall == Wall::open || distance >= reach * spacing) return false;
    if (distance <= at_a_wall * spacing) return true;
    if (mirrors(wall)) add(P, end, end, mirror, place);
    return mirrors(wall);
  };
  if (ends(scene.walls.left, P.x[end] - grid.x0, 0, grid.x0)) return true;
  if (ends(scene.walls.right, grid.x1 - P.x[end], 0, grid.x1)) return true;
  if (ends(scene.walls.bottom, P.y[end] - grid.y0, 1, grid.y0)) return true;
  if (!ends(scene.walls.top, grid.y1 - P.y[end], 1, grid.y1)) return false;
  reference_y_ = grid.y1;  // along the top the way from one wall to the other is level, too
  return true;
}

Elements::Shape Elements::shape(const Points& P, const Element& element) const {
  const std::size_t a = element.a, b = element.b;
  Shape shape;
  if (element.mirror == 0) shape.along = pair(2 * (element.wall - P.x[a]), 0);
  if (element.mirror == 1) shape.along = pair(0, 2 * (element.wall - P.y[a]));
  if (element.mirror < 0) shape.along = pair(P.x[b] - P.x[a], P.y[b] - P.y[a]);
  shape.length = std::sqrt(shape.along[0] * shape.along[0] + shape.along[1] * shape.along[1]);
  // The half element before the axis has its middle half way to it; elsewhere the middle of the ends is meant.
  shape.radius = element.mirror == 0 ? 0.5 * (P.x[a] + element.wall) : 0.5 * (P.x[a] + P.x[b]);
  return shape;
}

double Elements::energy_of(const Element& element, const Shape& shape) const {
  const double hoop = about_axis_ ? std::log(shape.radius / element.radius) : 0;
  return share(element) * element.volume *
         law_.energy_density(std::log(shape.length / element.rest) + element.strain, hoop);
}

/// dU/dl = V_0 sigma_1' / l pulls the ends together; dU/dr = V_0 sigma_2' / r pulls them to the axis.
void Elements::add_element(const Points& P, const Element& element, std::size_t e) {
  const Shape now = shape(P, element);
  const double strain = std::log(now.length / element.rest) + element.strain;
  const double hoop = about_axis_ ? std::log(now.radius / element.radius) : 0;
  const MembraneStress stress = law_.stress(strain, hoop);
  energy_[e] = energy_of(element, now);
  const Pair pull = now.along * (-element.volume * stress.tangent / (now.length * now.length));
  const double part = element.mirror == 1 ? 1 : 0.5;  // dr/dx of either point; of a half element along the axis, whole
  const double turn = about_axis_ ? -part * share(element) * element.volume * stress.hoop / now.radius : 0;
  pull_[e] = pull, turn_[e] = turn;
  const std::size_t a = element.a - range_.begin, b = element.b - range_.begin;
  force_[a] += pair(turn, 0) - pull;
  const auto tell = [&](std::size_t p) {
    strain_[p] += 0.5 * strain, hoop_[p] += 0.5 * hoop, parts_[p] += 0.5;
    tension_[p] += 0.5 * stress.tangent, ring_[p] += 0.5 * stress.hoop;
  };
  tell(a);
  if (element.mirror >= 0) return;
  force_[b] += pair(turn, 0) + pull;
  tell(b);
}

/// Plane: (x - x_ref) dy; about an axis: pi r^2 dz. Signed by the sense in which the points run.
Elements::Swept Elements::swept(const Points& P, const Element& element) const {
  using std::numbers::pi;
  const std::size_t a = element.a, b = element.b;
  // A half element before the first point runs from its wall, one after the last to it.
  const double sense = a == range_.begin ? 1 : -1;
  if (element.mirror == 0) {  // level; from its end the way goes on along the wall
    const double across = about_axis_ ? pi * element.wall * element.wall : element.wall - reference_x_;
    return {sense * across * (P.y[a] - reference_y_), pair(0, sense * across), pair(0, 0)};
  }
  const double ra = P.x[a] - reference_x_, rb = P.x[b] - reference_x_;
  if (element.mirror == 1) {
    const double rise = sense * (P.y[a] - element.wall);
    if (about_axis_) return {pi * ra * ra * rise, pair(2 * pi * ra * rise, sense * pi * ra * ra), pair(0, 0)};
    return {ra * rise, pair(rise, sense * ra), pair(0, 0)};
  }
  const double rise = P.y[b] - P.y[a];
  if (!about_axis_) {
    const double middle = 0.5 * (ra + rb);
    return {middle * rise, pair(0.5 * rise, -middle), pair(0.5 * rise, middle)};
  }
  const double third = pi / 3, squares = third * (ra * ra + ra * rb + rb * rb);
  return {squares * rise, pair(third * (2 * ra + rb) * rise, -squares), pair(third * (2 * rb + ra) * rise, squares)};
}

double Elements::enclosed_volume(const Points& P) const {
  double sum = 0;
  for (const Element& element : elements_) sum += swept(P, element).volume;
  return sum;
}

/// -p dV of the points' places.
void Elements::add_ambient(const Points& P) {
  if (ambient_ == 0) return;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const Element& element = elements_[e];
    const Swept& now = swept_[e] = swept(P, element);
    force_[element.a - range_.begin] -= ambient_ * now.by_a;
    force_[element.b - range_.begin] -= ambient_ * now.by_b;
  }
}

/// A mirrored end has its own image for a neighbour.
void Elements::set_tangents(Points& P) const {
  const auto set = [&P](std::size_t p, const Vec<2>& t) { P.tx[p] = t[0], P.ty[p] = t[1]; };
  for_points(range_, [&](std::size_t p) { set(p, tangent_at(P, range_, p, closed_)); });
  for (const Element& element : elements_) {
    if (element.mirror < 0) continue;
    const std::size_t p = element.a;
    const bool first = p == range_.begin;
    const std::size_t inner = first ? p + 1 : p - 1;
    const Pair image = pair(P.x[p], P.y[p]) + shape(P, element).along;
    const Pair way = (first ? 1.0 : -1.0) * (pair(P.x[inner], P.y[inner]) - image);
    const double length = std::sqrt(way[0] * way[0] + way[1] * way[1]);
    set(p, length > 0 ? Vec<2>{way[0] / length, way[1] / length} : Vec<2>{});
  }
}

bool Elements::update(Points& P, std::size_t& bad) {
  for (auto* array : {&strain_, &hoop_, &tension_, &ring_, &parts_}) std::fill(array->begin(), array->end(), 0.0);
  std::fill(force_.begin(), force_.end(), Pair{});
  for (std::size_t e = 0; e < elements_.size(); ++e) add_element(P, elements_[e], e);
  add_ambient(P);
  set_tangents(P);
  const Trouble trouble = find_at_points(range_, Trouble{}, [&](std::size_t p, Trouble& found) {
    const std::size_t k = p - range_.begin;
    P.strain[p] = strain_[k] / parts_[k], P.hoop[p] = hoop_[k] / parts_[k];
    const Stress s = Membrane::turned(tension_[k] / parts_[k], {P.tx[p], P.ty[p]});
    P.sxx[p] = s.xx, P.syy[p] = s.yy, P.sxy[p] = s.xy, P.szz[p] = ring_[k] / parts_[k];
    if (!std::isfinite(P.strain[p])) found.note(TroubleKind::unsound, p);
  });
  bad = trouble.slot;
  return trouble.kind == TroubleKind::none;
}

void Elements::update_ambient(const Points& P) {
  std::fill(force_.begin(), force_.end(), Pair{});
  add_ambient(P);
}

double Elements::strain_energy(const Points& P) const {
  double sum = 0;
  for (const Element& element : elements_) sum += energy_of(element, shape(P, element));
  return sum;
}

void Elements::settle(const Points& P) {
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const Element& element = elements_[e];
    const std::size_t a = element.a - range_.begin, b = element.b - range_.begin;
    const Pair turn = pair(turn_[e], 0);
    Pair work = (turn - pull_[e]) * moved_[a];
    if (element.mirror < 0) work += (turn + pull_[e]) * moved_[b];
    const double defect = energy_[e] - energy_of(element, shape(P, element)) - (work[0] + work[1]);
    heat_[a] += 0.5 * defect, heat_[b] += 0.5 * defect;
    if (ambient_ != 0) settle_ambient(P, element, swept_[e]);
  }
}

/// p (V_old - V_new) - F . moved in two parts. What the volume's curvature makes of the way from the old place to the
/// new one is the element's; that this way is not `moved` is the points', of whose forces alone the reference drops
/// out.
void Elements::settle_ambient(const Points& P, const Element& element, const Swept& before) {
  const std::size_t a = element.a - range_.begin, b = element.b - range_.begin;
  const auto sum = [](Pair v) { return v[0] + v[1]; };
  const auto way = [&](std::size_t k) { return pair(P.x[k + range_.begin], P.y[k + range_.begin]) - place_[k]; };
  const Pair way_a = way(a), way_b = way(b);
  const double curved =
      ambient_ * (before.volume - swept(P, element).volume + sum(before.by_a * way_a) + sum(before.by_b * way_b));
  heat_[a] += 0.5 * curved + ambient_ * sum(before.by_a * (moved_[a] - way_a));
  heat_[b] += 0.5 * curved + ambient_ * sum(before.by_b * (moved_[b] - way_b));
}

}  // namespace tether::mpm
