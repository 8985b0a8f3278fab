// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/fields_in_turn.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace tether {

FieldsInTurn::FieldsInTurn(const Snapshot& snapshot)
    : time_(snapshot.time),
      count_(snapshot.fields.empty() ? 0 : snapshot.fields.front().values.size()),
      view_([&snapshot](std::size_t field) { return std::span(snapshot.fields[field].values); }) {
  for (const Field& field : snapshot.fields) {
    if (field.values.size() != count_)
      throw std::invalid_argument(fmt::format("field {} with {} numbers where {} with {} was expected",
                                              field.quantity.name, field.values.size(),
                                              snapshot.fields.front().quantity.name, count_));
    quantities_.push_back(field.quantity);
  }
}

void FieldsInTurn::fill(std::size_t field, std::span<double> numbers) const {
  if (!view_) return fill_(field, numbers);
  const auto there = view_(field);
  std::copy(there.begin(), there.end(), numbers.begin());
}

std::span<const double> FieldsInTurn::numbers(std::size_t field, std::span<double> room) const {
  if (view_) return view_(field);
  fill_(field, room);
  return room;
}

Snapshot FieldsInTurn::snapshot() const {
  Snapshot all{time_, {}};
  for (std::size_t k = 0; k < quantities_.size(); ++k) {
    Field& field = all.fields.emplace_back(Field{quantities_[k], std::vector<double>(count_)});
    fill(k, field.values);
  }
  return all;
}

}  // namespace tether
