// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "base/letters.hpp"
#include "studies/runs/crew.hpp"

namespace tether {

/// Programs of this command on this machine or on others, numbered from 1, that do runs: one at a time each, wherever
/// they see the studies' folder. Letters go through a box that whoever started them all has at its other end.
class RemoteCrew : public Crew {
 public:
  RemoteCrew(std::unique_ptr<LetterBox> box, int programs);

  /// Waits until all have said what they are. Throws InputError where one is of another build or has other words than
  /// this one, which is `program`; FileError where all are lost.
  void meet(const std::string& program);

  std::size_t size() const override { return idle_.size() + busy_.size(); }
  std::size_t count() const override { return busy_.size(); }
  void start(std::size_t id, const RunTask& task) override;
  std::optional<Done> take() override;
  void tell(int signal) override;
  void drop_all() override;
  int news() const override { return box_->socket(); }

 private:
  struct Run {
    std::size_t id = 0;  // the scheduler's
    long long number = 0;
    RunTask task;
  };
  std::optional<Done> read(const Letter& letter);
  std::optional<Done> lose(int program);

  std::unique_ptr<LetterBox> box_;
  std::set<int> idle_;
  std::map<int, Run> busy_;               // by program
  std::map<std::string, int> lost_with_;  // how many programs were lost with a run, by its key
  long long next_number_ = 0;             // of a run, so that one that was dropped is not taken for another
};

/// Says to the first program what this one is, `program`, and does the runs that it deals out, until its end of the box
/// closes: then the run under way stops at its next look at signals, as at SIGTERM. Returns the exit code of the
/// program.
int serve(LetterBox& box, const std::string& program);

}  // namespace tether
