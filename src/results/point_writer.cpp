// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/point_writer.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace tether {
namespace {

void check_points(const FieldsInTurn& first) {
  const auto has = [&](const char* name) {
    return std::any_of(first.quantities().begin(), first.quantities().end(),
                       [&](const Quantity& quantity) { return quantity.name == name; });
  };
  if (!has("x") || !has("y")) throw std::invalid_argument("a snapshot of points needs the fields x and y");
  if (first.count() == 0) throw std::invalid_argument("a snapshot without points");
}

}  // namespace

PointWriter::PointWriter(std::filesystem::path folder, Provenance provenance, VtkFiles vtk, bool changing,
                         const PointKind& kind)
    : folder_(std::move(folder)),
      provenance_(std::move(provenance)),
      changing_(changing),
      kind_(kind),
      vtk_(folder_, kind.file, kind.ending, vtk) {}

void PointWriter::append(const FieldsInTurn& snapshot) {
  if (!file_) {
    check_points(snapshot);
    const std::vector<Axis> axes{{kind_.axis, snapshot.count(), {}, changing_}};
    file_.emplace(folder_ / fmt::format("{}.nc", kind_.file), axes, snapshot, provenance_);
  }
  vtk_.append(
      *file_,
      [&] {
        if (kind_.ending == std::string_view("vtu")) return vtk_of_simplices(snapshot.count(), kind_.corners);
        return kind_.corners == 1 ? vtk_of_points(snapshot.count()) : vtk_of_facets(snapshot.count(), kind_.corners);
      },
      snapshot);
}

void PointWriter::close() {
  if (file_) file_->close();
}

}  // namespace tether
