// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/runs/local_crew.hpp"

namespace tether {

void LocalCrew::start(std::size_t id, const RunTask& task) {
  workers_.start(id, [&task] { return do_run(task); });
  tasks_[id] = task;
}

std::optional<Done> LocalCrew::take() {
  const auto ended = workers_.take();
  if (!ended) return std::nullopt;
  const RunTask task = std::move(tasks_.extract(ended->id).mapped());
  return Done{.id = ended->id, .record = record_end(task, *ended)};
}

void LocalCrew::drop_all() {
  workers_.drop_all();
  tasks_.clear();
}

}  // namespace tether
