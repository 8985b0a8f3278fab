// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/history_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <stdexcept>

#include "results/netcdf_file.hpp"

namespace tether {
namespace {

std::size_t longest(const HistoryLayout& layout) {
  std::size_t length = 1;
  for (const auto& name : layout.body_names) length = std::max(length, name.size());
  for (const auto& name : layout.point_names) length = std::max(length, name.size());
  return length;
}

HistoryLayout checked(HistoryLayout layout) {
  if (layout.quantities.empty() || layout.quantities.front().name != "time") {
    throw std::invalid_argument("the first quantity of a history must be time");
  }
  return layout;
}

}  // namespace

HistoryWriter::HistoryWriter(const std::filesystem::path& folder, HistoryLayout layout, const Provenance& provenance)
    : layout_(checked(std::move(layout))),
      columns_(layout_.column_names().size()),
      numbers_(folder / "history.nc", NetcdfFormat::offset64),
      lines_(folder / "history.txt") {
  define(provenance);
  lines_.append(fmt::format("# {}\n", fmt::join(layout_.column_names(), " ")));
}

/// A dimension of length 0 would mean "unlimited": without bodies (or points) there is none, nor their variables.
void HistoryWriter::define(const Provenance& provenance) {
  write_provenance(numbers_, provenance);
  const int time = numbers_.dimension("time", NetcdfFile::unlimited);
  const int letters = numbers_.dimension("name_length", longest(layout_));
  const bool bodies = !layout_.body_names.empty(), points = !layout_.point_names.empty();
  const int body = bodies ? numbers_.dimension("body", layout_.body_names.size()) : -1;
  const int point = points ? numbers_.dimension("point", layout_.point_names.size()) : -1;
  for (const auto& q : layout_.quantities) {
    std::vector<int> dimensions{time};
    if (q.per == Per::body) dimensions.push_back(body);
    if (q.per == Per::point) dimensions.push_back(point);
    const bool any = layout_.count(q) > 0;
    variables_.push_back(!any               ? -1
                         : q.name == "time" ? define_time(numbers_, q, time, provenance.units)
                                            : define_quantity(numbers_, q, dimensions, provenance.units));
  }
  const int body_name = bodies ? numbers_.text_variable("body_name", {body, letters}) : -1;
  const int point_name = points ? numbers_.text_variable("point_name", {point, letters}) : -1;
  numbers_.end_definitions();
  write_names(body_name, layout_.body_names);
  write_names(point_name, layout_.point_names);
  numbers_.sync();
}

void HistoryWriter::write_names(int variable, const std::vector<std::string>& names) {
  const auto length = longest(layout_);
  for (std::size_t k = 0; k < names.size(); ++k) {
    auto padded = names[k];
    padded.resize(length, '\0');  // readers of character variables cut at the first NUL
    numbers_.put_text(variable, {{k, 0}, {1, length}}, padded);
  }
}

void HistoryWriter::append(const Record& record) {
  if (record.size() != columns_) {
    throw std::invalid_argument(fmt::format("a record of {} numbers for {} columns", record.size(), columns_));
  }
  append_numbers(record);
  append_line(record);
}

void HistoryWriter::append_numbers(const Record& record) {
  numbers_.reserve(record.size() * sizeof(double));  // else a full disk could leave a record that is counted but lost
  std::span<const double> rest(record);
  for (std::size_t k = 0; k < variables_.size(); ++k) {
    const auto& q = layout_.quantities[k];
    const auto count = layout_.count(q);
    if (count == 0) continue;
    const auto part =
        q.per == Per::scene ? NetcdfFile::Part{{records_}, {1}} : NetcdfFile::Part{{records_, 0}, {1, count}};
    numbers_.put(variables_[k], part, rest.first(count));
    rest = rest.subspan(count);
  }
  numbers_.sync();
  ++records_;
}

void HistoryWriter::append_line(const Record& record) { lines_.append(fmt::format("{}\n", fmt::join(record, " "))); }

void HistoryWriter::close() { numbers_.close(); }

}  // namespace tether
