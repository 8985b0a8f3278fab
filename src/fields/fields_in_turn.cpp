// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/fields_in_turn.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace tether {

FieldsInTurn::FieldsInTurn(const Snapshot& snapshot)
    : time_(snapshot.time),
      count_(snapshot.fields.empty() ? 0 : snapshot.fields.front().values.size()),
      fill_([&snapshot](std::size_t field, std::span<double> numbers) {
        std::copy_n(snapshot.fields[field].values.begin(), numbers.size(), numbers.begin());
      }) {
  for (const Field& field : snapshot.fields) {
    if (field.values.size() != count_)
      throw std::invalid_argument(fmt::format("field {} with {} numbers where {} with {} was expected",
                                              field.quantity.name, field.values.size(),
                                              snapshot.fields.front().quantity.name, count_));
    quantities_.push_back(field.quantity);
  }
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
