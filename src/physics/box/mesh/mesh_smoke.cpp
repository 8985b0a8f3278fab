// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/mesh/mesh_smoke.hpp"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/numbers.hpp"

namespace tether::coupled {

ContentCarrier::ContentCarrier(const FlowMesh& old, const FaceValues& v, const MeshVelocity& velocity,
                               const FlowMesh& next, double h)
    : old_(old), v_(v), velocity_(velocity), next_(next), h_(h) {
  std::size_t near = 0;
  each_place_within(next, [&](std::size_t /*cell*/, const Vec<3>& x) {
    const MeshVelocity::Origin origin = velocity.before(x, h, near);
    near = origin.from;
    source_.push_back({origin.x, origin.cell, origin.face});
  });
  join_parts();
}

/// Regions of both meshes that something is carried between are one part of the fluid.
void ContentCarrier::join_parts() {
  const std::size_t regions = at(old_.regions) + at(next_.regions);
  std::vector<std::size_t> rank(regions, 0), parent(regions);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  boost::disjoint_sets<std::size_t*, std::size_t*> sets(rank.data(), parent.data());
  for (std::size_t k = 0; k < source_.size(); ++k)
    sets.union_set(at(old_.region[source_[k].cell]), at(old_.regions + next_.region[k / next_.corners()]));
  std::vector<std::size_t> number(regions, regions);
  const auto part_of = [&](std::size_t region) {
    std::size_t& of = number[sets.find_set(region)];
    return of == regions ? of = parts_++ : of;
  };
  for (std::size_t r = 0; r < regions; ++r) (r < at(old_.regions) ? part_of_old_ : part_of_next_).push_back(part_of(r));
}

ContentCarrier::Means ContentCarrier::means_of(const CellField& field, std::span<const double> entering) const {
  Means means;
  const std::size_t each = next_.corners();
  for (std::size_t cell = 0; cell < next_.cells(); ++cell) {
    double sum = 0, low = INFINITY, high = -INFINITY;
    for (std::size_t k = cell * each; k < (cell + 1) * each; ++k) {
      const Source& source = source_[k];
      const bool entered = source.face >= 0 && !std::isnan(entering[at(source.face)]);
      const double value = entered ? entering[at(source.face)] : field.limited_at(source.cell, source.x);
      const auto extrema = entered ? std::array{value, value} : field.extrema(source.cell);
      sum += value, low = std::min(low, extrema[0]), high = std::max(high, extrema[1]);
    }
    means.value.push_back(sum / static_cast<double>(each)), means.low.push_back(low), means.high.push_back(high);
  }
  return means;
}

/// What goes out through a face in the step [volume].
double ContentCarrier::out_of(std::size_t face) const {
  double out = 0;
  for (std::size_t a = 0; a < at(old_.dim); ++a) out += h_ * old_.area[face][a] * v_[a][old_.cell_of(face)];
  return out;
}

/// What goes out in a step has been on its way to the face: it is met at four times of it.
void ContentCarrier::pass_through(const CellField& field, std::span<const FaceValue> entrances,
                                  std::vector<double>& gained, Carried& carried) const {
  constexpr std::array times{0.125, 0.375, 0.625, 0.875};
  for (const FaceValue& entrance : entrances) {
    const std::size_t cell = old_.cell_of(entrance.face);
    const double out = out_of(entrance.face);
    double met = entrance.value;
    for (std::size_t k = 0; k < times.size() && out > 0; ++k) {
      const MeshVelocity::Origin origin = velocity_.before(old_.middle_of_face(entrance.face), times[k] * h_, cell);
      met = (k == 0 ? 0 : met) + field.limited_at(origin.cell, origin.x) / static_cast<double>(times.size());
    }
    (out > 0 ? carried.out : carried.in) += std::abs(out) * met;
    gained[part_of_old_[at(old_.region[cell])]] -= out * met;
  }
}

std::vector<ContentCarrier::Part> ContentCarrier::parts_of(std::span<const double> content,
                                                           std::span<const double> gained) const {
  std::vector<Part> parts(parts_);
  for (std::size_t k = 0; k < parts_; ++k) parts[k].holds = gained[k];
  for (std::size_t cell = 0; cell < content.size(); ++cell)
    parts[part_of_old_[at(old_.region[cell])]].holds += content[cell];
  for (std::size_t cell = 0; cell < next_.cells(); ++cell) {
    Part& part = parts[part_of_next_[at(next_.region[cell])]];
    part.volume += next_.volume[cell], part.cells.push_back(cell);
  }
  return parts;
}

void ContentCarrier::give_away_lost(std::vector<Part>& parts) const {
  for (std::size_t region = 0; region < part_of_old_.size(); ++region) {
    Part& part = parts[part_of_old_[region]];
    if (!part.cells.empty() || part.holds == 0) continue;
    const auto first = std::ranges::find(old_.region, static_cast<int>(region)) - old_.region.begin();
    Vec<3> x = old_.middle(static_cast<std::size_t>(first));
    const std::size_t nearest = CellFinder(next_).cell_at(x);
    parts[part_of_next_[at(next_.region[nearest])]].holds += std::exchange(part.holds, 0);
  }
}

/// Brings what a part's cells have in sum to what the part holds.
void ContentCarrier::settle(const Part& part, const Means& means, std::vector<double>& content) const {
  double sum = 0, room = 0;
  for (const std::size_t cell : part.cells) sum += content[cell];
  const double missing = part.holds - sum;
  const std::vector<double>& end = missing > 0 ? means.high : means.low;
  for (const std::size_t cell : part.cells) room += next_.volume[cell] * end[cell] - content[cell];
  const double filled = room != 0 ? std::clamp(missing / room, 0.0, 1.0) : 0;
  for (const std::size_t cell : part.cells) content[cell] += filled * (next_.volume[cell] * end[cell] - content[cell]);
  const double rest = missing - filled * room, left = part.holds - rest;
  for (const std::size_t cell : part.cells)
    content[cell] +=
        left > 0 && part.holds >= 0 ? rest / left * content[cell] : rest / part.volume * next_.volume[cell];
}

ContentCarrier::Carried ContentCarrier::carry(std::span<const double> content,
                                              std::span<const FaceValue> entrances) const {
  std::vector<double> density, entering(old_.faces(), NAN), gained(parts_, 0.0);
  for (std::size_t cell = 0; cell < content.size(); ++cell) density.push_back(content[cell] / old_.volume[cell]);
  std::vector<FaceValue> comes_in;
  for (const FaceValue& entrance : entrances) {
    if (out_of(entrance.face) >= 0) continue;
    comes_in.push_back(entrance), entering[entrance.face] = entrance.value;
  }
  const CellField field(old_, density, comes_in);
  const Means means = means_of(field, entering);
  Carried carried;
  pass_through(field, entrances, gained, carried);
  std::vector<Part> parts = parts_of(content, gained);
  give_away_lost(parts);
  for (std::size_t cell = 0; cell < next_.cells(); ++cell)
    carried.content.push_back(next_.volume[cell] * means.value[cell]);
  for (const Part& part : parts) settle(part, means, carried.content);
  return carried;
}

}  // namespace tether::coupled
