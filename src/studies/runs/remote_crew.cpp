// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/runs/remote_crew.hpp"

#include <fmt/format.h>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "base/diagnostics.hpp"
#include "studies/runs/errand.hpp"

namespace tether {
namespace {

/// Programs that may be lost with a run before it is taken for the reason.
constexpr int most_lost = 2;

/// Waits until a file is seen that another machine has written: a file system of a network may remember for up to a
/// minute that there was none. A look at the folder makes it look again.
void wait_for(const std::filesystem::path& file) {
  constexpr auto longest = std::chrono::seconds(90);
  constexpr auto pause = std::chrono::milliseconds(50);
  const auto end = std::chrono::steady_clock::now() + longest;
  std::error_code ignored;
  while (!std::filesystem::exists(file, ignored) && std::chrono::steady_clock::now() < end) {
    std::filesystem::directory_iterator{file.parent_path(), ignored};
    std::this_thread::sleep_for(pause);
  }
}

[[noreturn]] void refuse_closed() {
  throw FileError("what carries messages between the programs of this command has ended");
}

}  // namespace

RemoteCrew::RemoteCrew(std::unique_ptr<LetterBox> box, int programs) : box_(std::move(box)) {
  for (int program = 1; program <= programs; ++program) idle_.insert(program);
}

void RemoteCrew::meet(const std::string& program) {
  std::set<int> met;
  while (met.size() < size()) {
    const auto letter = box_->wait();
    if (!letter) refuse_closed();
    if (letter->text.empty()) {
      lose(letter->who), met.erase(letter->who);
      continue;
    }
    const Errand errand(letter->text);
    if (errand.kind() == ErrandKind::hello && errand.text() != program)
      throw InputError(
          fmt::format("mpirun has started different programs: '{}' as the first, '{}' as number {}. Give all machines "
                      "the same build "
                      "of tether, and all programs the same words",
                      program, errand.text(), letter->who));
    met.insert(letter->who);
  }
}

void RemoteCrew::start(std::size_t id, const RunTask& task) {
  const int program = idle_.extract(idle_.begin()).value();
  const Run& run = busy_[program] = {id, next_number_++, task};
  box_->send({program, Errand::of_run(run.number, task)});
}

std::optional<Done> RemoteCrew::take() {
  while (const auto letter = box_->take()) {
    if (auto done = read(*letter)) return done;
  }
  if (box_->is_closed()) refuse_closed();
  return std::nullopt;
}

/// What a letter makes of the run that its sender has, if any.
std::optional<Done> RemoteCrew::read(const Letter& letter) {
  if (letter.text.empty()) return lose(letter.who);  // as who carries the letters says it
  const Errand errand(letter.text);
  const auto run = busy_.find(letter.who);
  if (run == busy_.end() || run->second.number != errand.number()) return std::nullopt;  // it was dropped
  if (errand.kind() == ErrandKind::blind) throw FileError(errand.text());
  Done done{.id = run->second.id, .record = record_of(errand.text())};
  if (done.record.ending.exit_code == exit_done) wait_for(run->second.task.folder / "run.txt");
  busy_.erase(run);
  idle_.insert(letter.who);
  return done;
}

std::optional<Done> RemoteCrew::lose(int program) {
  idle_.erase(program);
  const auto lost = busy_.extract(program);
  if (size() == 0) throw FileError("all programs of this command that do runs are lost; the same command goes on");
  if (lost.empty()) return std::nullopt;
  const Run& run = lost.mapped();
  const int times = ++lost_with_[run.task.key];
  const std::string why = fmt::format("{} programs of this command were lost while they did this run", times);
  return Done{.id = run.id, .record = {run.task.key, {exit_signal + SIGKILL, why}}, .given_back = times < most_lost};
}

void RemoteCrew::tell(int signal) {
  for (const auto& [program, run] : busy_) box_->send({program, Errand::of_signal(run.number, signal)});
}

void RemoteCrew::drop_all() {
  for (const auto& [program, run] : busy_) {
    box_->send({program, Errand::of_signal(run.number, SIGKILL)});
    idle_.insert(program);
  }
  busy_.clear();
}

}  // namespace tether
