// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/formula.hpp"

#include <algorithm>

namespace tether::published {

Formula::Formula(Parts parts) : parts_(std::move(parts)) {
  of_deck_ = parts_.names.empty();
  for (const Call& call : parts_.calls) {
    of_deck_ = of_deck_ && call.function->of_deck;
    for (const Argument& argument : call.arguments) {
      const auto* formula = std::get_if<std::shared_ptr<const Formula>>(&argument);
      of_deck_ = of_deck_ && (formula == nullptr || (*formula)->of_deck());
    }
  }
}

std::vector<std::string> Formula::keys() const {
  std::vector<std::string> keys = parts_.names;
  for (const Call& call : parts_.calls) {
    for (std::size_t k = 0; k < call.arguments.size(); ++k) {
      if (call.function->arguments[k] != ArgumentKind::number) continue;
      const auto more = std::get<std::shared_ptr<const Formula>>(call.arguments[k])->keys();
      keys.insert(keys.end(), more.begin(), more.end());
    }
  }
  return keys;
}

std::vector<std::string> Formula::columns() const {
  std::vector<std::string> columns;
  for (const Call& call : parts_.calls) {
    for (std::size_t k = 0; k < call.arguments.size(); ++k) {
      if (call.function->arguments[k] == ArgumentKind::column)
        columns.push_back(std::get<std::string>(call.arguments[k]));
      if (call.function->arguments[k] != ArgumentKind::number) continue;
      const auto more = std::get<std::shared_ptr<const Formula>>(call.arguments[k])->columns();
      columns.insert(columns.end(), more.begin(), more.end());
    }
  }
  return columns;
}

Numbers Formula::of_calls(const RunFiles& run) const {
  Numbers values;
  for (const Call& call : parts_.calls) values.push_back(call.function->value(run, call.arguments));
  return values;
}

double Formula::of_run(const RunFiles& run) const {
  Numbers values;
  for (const std::string& key : parts_.names) values.push_back(run.summary(key));
  const Numbers calls = of_calls(run);
  values.insert(values.end(), calls.begin(), calls.end());
  return (*parts_.expression)(values);
}

Numbers Formula::of_each(const RunFiles& run, const std::vector<Numbers>& fields, std::size_t count) const {
  const Numbers calls = of_calls(run);
  Numbers values(parts_.names.size() + calls.size()), results(count);
  std::copy(calls.begin(), calls.end(), values.begin() + static_cast<std::ptrdiff_t>(parts_.names.size()));
  for (std::size_t p = 0; p < count; ++p) {
    for (std::size_t k = 0; k < fields.size(); ++k) values[k] = fields[k].at(p);
    results[p] = (*parts_.expression)(values);
  }
  return results;
}

}  // namespace tether::published
