// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "studies/runs/crew.hpp"

namespace tether {

/// Processes of this machine, children of this one.
class LocalCrew : public Crew {
 public:
  explicit LocalCrew(int jobs) : size_(static_cast<std::size_t>(jobs)) {}

  std::size_t size() const override { return size_; }
  std::size_t count() const override { return workers_.count(); }
  void start(std::size_t id, const RunTask& task) override;
  std::optional<Done> take() override;
  void tell(int signal) override { workers_.tell(signal); }
  void drop_all() override;
  int news() const override { return -1; }

 private:
  std::size_t size_;
  Workers workers_;
  std::map<std::size_t, RunTask> tasks_;  // of those under way
};

}  // namespace tether
