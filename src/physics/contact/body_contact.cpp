// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/contact/body_contact.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "base/numbers.hpp"
#include "physics/contact/plane_force.hpp"

namespace tether::contact {
namespace {

/// Numbers that no deck gives. The guards' gap is a part of the other's, which points of quadrature use up at no
/// pressure that bodies bear.
constexpr double part_of_modulus = 0.1, part_of_gap = 0.25;

/// A speed that counts as rest: a small part of that with which the bodies start, or fall by as far as the scene is
/// high; without any, of the speed of waves [velocity].
double slow_speed(const Solids& solids, double gravity) {
  constexpr double part = 1e-4, part_of_waves = 1e-6;
  const auto d = at(solids.mesh.dim());
  double low = INFINITY, high = -INFINITY, fastest = 0, waves = 0;
  for (std::size_t k = 1; k < solids.mesh.x.size(); k += d)
    low = std::min(low, solids.mesh.x[k]), high = std::max(high, solids.mesh.x[k]);
  for (const SolidRegion& region : solids.regions) {
    fastest = std::max(fastest, std::sqrt(dot(region.velocity, region.velocity)));
    waves = std::max(waves, std::sqrt(youngs_modulus(region.law) / region.density));
  }
  fastest = std::max(fastest, std::sqrt(std::abs(gravity) * (high - low)));
  return fastest > 0 ? part * fastest : part_of_waves * waves;
}

double farthest_of(std::span<const double> change) {
  double farthest = 0;
  for (const double way : change) farthest = std::max(farthest, std::abs(way));
  return farthest;
}

/// How near surfaces may come in one correction that are `away` from each other: what presses them is then of the size
/// that it has to be, or grows by some times.
double nearest_after(double away, double gap, double left) { return std::min(left * away, 0.7 * gap); }

}  // namespace

BodyContact::BodyContact(const Solids& solids, double gravity, Team& team)
    : solids_(solids),
      contact_(*solids.contact),
      team_(team),
      surface_(contact_surface(solids.mesh, contact_.nodes, contact_.obstacles, contact_.parts)),
      pairs_(surface_, {contact_.bodies, contact_.itself}, team),
      gap_(contact_.gap),
      guard_gap_(part_of_gap * contact_.gap),
      stick_(contact_.stick > 0 ? contact_.stick : slow_speed(solids, gravity)) {
  for (const SolidRegion& region : solids.regions)
    modulus_.push_back(contact_.stiffness > 0 ? contact_.stiffness : part_of_modulus * youngs_modulus(region.law));
}

void BodyContact::begin(std::span<const double> q0, double dt) {
  surface_.places.find(q0, x0_);
  dt_ = dt;
  rule_.friction = dt > 0 ? contact_.friction : 0;
  ease_friction(1);
  rule_.damped = is_damped(contact_), rule_.at_end = convex_ = false;
  met_ = EigenSparse();
  covered_ = covered_ && pairs_.hold(x0_);  // pairs are of places, not of steps
  if (covered_) measure_start();
  cover(x0_, x0_);
}

void BodyContact::begin_at_end(std::span<const double> q0, double dt, bool convex) {
  begin(q0, dt);
  rule_.damped = false, rule_.at_end = true, convex_ = convex;
}

bool BodyContact::presses(std::span<const double> q1) {
  place(q1);
  return !active_.empty();
}

double BodyContact::modulus(int side) const {
  return side < 0 ? INFINITY : modulus_[tether::at(surface_.side_region[tether::at(side)])];
}

PairScale BodyContact::scale_of(const ContactPair& pair) const {
  const double gap = pair.guard ? guard_gap_ : gap_;
  return {0.5 * std::min(modulus(pair.side), modulus(pair.other)) * pair.area * gap, gap * gap, pair.parallel};
}

PairScale BodyContact::scale_of(const ContactPoint& point, bool guard) const {
  const double gap = guard ? guard_gap_ : gap_;
  return {0.5 * modulus(point.side) * point.area * gap, gap * gap, 0};
}

/// Points of quadrature, and after these guards.
const ContactPoint& BodyContact::point_of(std::size_t number) const {
  return is_guard(number) ? surface_.guards[number - surface_.points.size()] : surface_.points[number];
}

/// Sees to it that all pairs are known that can meet between the start, x1 and x2, and which of them x1 and x2 are
/// near to.
void BodyContact::cover(std::span<const double> x1, std::span<const double> x2) {
  if (!covered_ || !pairs_.hold(x1) || !pairs_.hold(x2)) find_pairs(x1, x2);
  if (!moved_little(x1) || !moved_little(x2)) find_near(x1, x2);
}

void BodyContact::find_pairs(std::span<const double> x1, std::span<const double> x2) {
  double farthest = 0;
  for (std::size_t k = 0; k < x0_.size(); ++k)
    farthest = std::max({farthest, std::abs(x1[k] - x0_[k]), std::abs(x2[k] - x0_[k])});
  pairs_.find({x0_, x1, x2}, gap_, std::max(gap_, 0.25 * farthest));
  covered_ = true;
  measure_start();
}

/// Measures how far the pairs are apart at the step's start.
void BodyContact::measure_start() {
  const auto& pairs = pairs_.pairs();
  s0_.resize(pairs.size());
  team_.each(0, pairs.size(), [&](std::size_t k) { s0_[k] = squared_distance(pairs[k], surface_.dim(), x0_); });
  near_to_.clear();
}

/// Returns whether no place has moved by more than a gap from where near pairs were looked for.
bool BodyContact::moved_little(std::span<const double> x) const {
  if (near_to_.size() != x.size()) return false;
  const std::size_t d = tether::at(surface_.dim());
  for (std::size_t k = 0; k < x.size(); k += d) {
    double square = 0;
    for (std::size_t i = k; i < k + d; ++i) square += (x[i] - near_to_[i]) * (x[i] - near_to_[i]);
    if (!(square <= gap_ * gap_)) return false;
  }
  return true;
}

/// Lists the pairs that press at the start, or do while no place moves by more than a gap from x1: Newton's method does
/// not go far after its first corrections. Where x2 is farther, all are near.
void BodyContact::find_near(std::span<const double> x1, std::span<const double> x2) {
  const auto& pairs = pairs_.pairs();
  near_.clear();
  near_to_.assign(x1.begin(), x1.end());
  const bool all = !moved_little(x2);
  std::vector<std::uint8_t> is_near(pairs.size());
  team_.each(0, all ? 0 : pairs.size(), [&](std::size_t k) {
    const double gap = pairs[k].guard ? guard_gap_ : gap_, reach = gap + 2 * gap_;
    is_near[k] = s0_[k] < gap * gap || squared_distance(pairs[k], surface_.dim(), x1) <= reach * reach ? 1 : 0;
  });
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (all || is_near[k] != 0) near_.push_back(k);
  }
  if (all) near_to_.clear();
}

void BodyContact::place(std::span<const double> q1) {
  surface_.places.find(q1, x1_);
  cover(x1_, x1_);
  find_active();
}

/// Finds what is nearer than the gap at either end of the step.
void BodyContact::find_active() {
  const auto& pairs = pairs_.pairs();
  std::vector<double> s1(near_.size());
  team_.each(0, near_.size(), [&](std::size_t n) { s1[n] = squared_distance(pairs[near_[n]], surface_.dim(), x1_); });
  active_.clear();
  for (std::size_t n = 0; n < near_.size(); ++n) {
    const std::size_t k = near_[n];
    const double gap = pairs[k].guard ? guard_gap_ : gap_;
    if (std::min(s0_[k], s1[n]) < gap * gap) active_.push_back({k, -1, s0_[k], s1[n]});
  }
  if (rule_.damped) find_nearest();
  find_active_at_planes();
}

/// Marks what each point of quadrature is nearest to, over the step's ends; pairs of a point stand together.
void BodyContact::find_nearest() {
  const auto& pairs = pairs_.pairs();
  for (std::size_t first = 0, next = 0; first < active_.size(); first = next) {
    if (pairs[active_[first].number].guard) return;
    const std::size_t point = pairs[active_[first].number].point;
    std::size_t nearest = first;
    for (next = first; next < active_.size(); ++next) {
      const ContactPair& pair = pairs[active_[next].number];
      if (pair.guard || pair.point != point) break;
      if (pair.area > 0 && active_[next].s0 + active_[next].s1 < active_[nearest].s0 + active_[nearest].s1)
        nearest = next;
    }
    active_[nearest].damps = pairs[active_[nearest].number].area > 0;
  }
}

void BodyContact::find_active_at_planes() {
  const std::size_t points = surface_.points.size() + surface_.guards.size(), d = tether::at(surface_.dim());
  for (std::size_t p = 0; p < contact_.planes.size(); ++p) {
    const auto height = [&](const double* x) {
      return d == 2 ? height_over<2>(contact_.planes[p], x) : height_over<3>(contact_.planes[p], x);
    };
    for (std::size_t k = 0; k < points; ++k) {
      const ContactPoint& point = point_of(k);
      if (point.side < 0) continue;
      const double gap = is_guard(k) ? guard_gap_ : gap_;
      const double h0 = height(&x0_[tether::at(point.place) * d]), h1 = height(&x1_[tether::at(point.place) * d]);
      if (std::min(h0, h1) < gap) active_.push_back({k, static_cast<int>(p), h0 * h0, h1 * h1, true});
    }
  }
}

double BodyContact::part_of_guess(std::span<const double> q0, std::span<const double> change) {
  guessed_far_ = farthest_of(change);
  return part_of_way(q0, change, 0.9, guessed_far_);
}

double BodyContact::part_of_correction(std::span<const double> q, std::span<const double> change) {
  return part_of_way(q, change, 0.4, std::max(guessed_far_, surface_.shortest));
}

/// Returns the part of the way from q by `change`, no longer than `longest` along an axis [length], after which no two
/// surfaces that are nearer than the gap are nearer to each other than `left` of their distance now, nor others than
/// 0.7 of the gap.
double BodyContact::part_of_way(std::span<const double> q, std::span<const double> change, double left,
                                double longest) {
  surface_.places.find(q, x1_);
  const double farthest = farthest_of(change);
  const double most = farthest > longest ? longest / farthest : 1;
  std::vector<double> then(q.begin(), q.end()), x2;
  for (std::size_t k = 0; k < then.size(); ++k) then[k] += most * change[k];
  surface_.places.find(then, x2);
  cover(x1_, x2);
  ways_.resize(x1_.size());
  for (std::size_t k = 0; k < x1_.size(); ++k) ways_[k] = x2[k] - x1_[k];
  const auto& pairs = pairs_.pairs();
  std::vector<double> parts(near_.size());
  team_.each(0, near_.size(), [&](std::size_t n) {
    const ContactPair& pair = pairs[near_[n]];
    const double away = std::sqrt(squared_distance(pair, surface_.dim(), x1_));
    const double to = nearest_after(away, pair.guard ? guard_gap_ : gap_, left);
    parts[n] = tether::part_of_way(pair, surface_.dim(), x1_, ways_, to);
  });
  double part = 1;
  for (const double one : parts) part = std::min(part, one);
  return most * part_before_planes(part, left);
}

/// Returns the same, of the part of the way that surfaces leave.
double BodyContact::part_before_planes(double part, double left) const {
  const std::size_t points = surface_.points.size() + surface_.guards.size(), d = tether::at(surface_.dim());
  for (const SurfacePlane& plane : contact_.planes) {
    for (std::size_t k = 0; k < points; ++k) {
      const ContactPoint& point = point_of(k);
      if (point.side < 0) continue;
      double away = 0, way = 0;
      for (std::size_t i = 0; i < d; ++i) {
        const std::size_t x = tether::at(point.place) * d + i;
        away += plane.normal[i] * (x1_[x] - plane.place[i]), way += plane.normal[i] * ways_[x];
      }
      const double most = away - nearest_after(away, is_guard(k) ? guard_gap_ : gap_, left);
      if (way < 0 && part * -way > most) part = most / -way;
    }
  }
  return part;
}

}  // namespace tether::contact
