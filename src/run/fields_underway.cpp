// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/fields_underway.hpp"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace tether {

std::shared_ptr<Channel> channel_for(const FieldsInTurn& snapshot, std::size_t most_waiting) {
  const std::size_t bytes_of_field = sizeof(double) * std::max<std::size_t>(1, snapshot.count());
  return std::make_shared<Channel>(std::max<std::size_t>(1, most_waiting / bytes_of_field));
}

FieldsInTurn fields_from(const std::shared_ptr<Channel>& channel, const FieldsInTurn& snapshot) {
  const std::shared_ptr<Channel> source(channel.get(), [channel](Channel* of) { of->close(); });
  const auto take = [source, count = snapshot.count(),
                     taken = std::make_shared<Channel::Numbers>()](std::size_t) -> std::span<const double> {
    *taken = nullptr;  // before the next one comes
    *taken = source->take();
    return {taken->get(), count};
  };
  return {snapshot.time(), snapshot.quantities(), snapshot.count(), FieldsInTurn::View(take)};
}

void put_fields(const FieldsInTurn& snapshot, Channel& channel) {
  Team alone;
  Team& team = snapshot.team() != nullptr ? *snapshot.team() : alone;
  const std::size_t fields = snapshot.quantities().size(), together = static_cast<std::size_t>(team.threads());
  for (std::size_t first = 0; first < fields; first += together) {
    std::vector<Channel::Numbers> made(std::min(together, fields - first));
    for (auto& numbers : made) numbers = std::make_unique_for_overwrite<double[]>(snapshot.count());
    team.each(0, made.size(),
              [&](std::size_t k) { snapshot.fill(first + k, std::span(made[k].get(), snapshot.count())); });
    for (auto& numbers : made) channel.put(std::move(numbers));
  }
}

}  // namespace tether
