// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <chrono>
#include <csignal>
#include <thread>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "base/numbers.hpp"
#include "deck/reader.hpp"
#include "studies/runs/errand.hpp"
#include "studies/runs/local_crew.hpp"
#include "studies/runs/remote_crew.hpp"
#include "studies/runs/run_record.hpp"

namespace tether {
namespace {

/// Does one run at a time for the first program.
class Server {
 public:
  explicit Server(LetterBox& box) : box_(box) {}

  void serve() {
    while (!box_.is_closed()) {
      heed(watch_.wait(patience, box_.socket()));
      while (const auto letter = box_.take()) obey(Errand(letter->text));
      report();
    }
    heed(SIGTERM);
    while (crew_.count() > 0) watch_.wait(patience), report();
  }

 private:
  void obey(const Errand& errand) {
    if (errand.kind() == ErrandKind::signal && errand.number() == number_) end_or_tell(errand);
    if (errand.kind() != ErrandKind::run) return;
    number_ = errand.number();
    task_ = task_of(errand.text());
    if (!sees_folder())
      box_.send({0, Errand::of_blind(number_, blind_text())});
    else if (!sees_the_same_files())
      box_.send({0, Errand::of_blind(number_, other_files_text())});
    else
      crew_.start(0, task_);
  }

  void end_or_tell(const Errand& errand) {
    const int signal = static_cast<int>(parse_integer(errand.text()).value_or(SIGTERM));
    if (signal == SIGKILL)
      crew_.drop_all();
    else
      crew_.tell(signal);
  }

  /// Looks for some seconds: a file system of a network may show late what another machine has made.
  bool sees_folder() const {
    constexpr int looks = 50;
    constexpr auto pause = std::chrono::milliseconds(100);
    std::error_code ignored;
    for (int look = 0; look < looks; ++look) {
      if (std::filesystem::exists(task_.sign, ignored)) return true;
      std::this_thread::sleep_for(pause);
    }
    return false;
  }

  std::string blind_text() const {
    return fmt::format("{} does not see the folder {} of this study: give with --out one that all machines share",
                       host_name(), std::filesystem::absolute(task_.sign).parent_path().string());
  }

  /// Returns whether the deck comes to the same run here: its files of particles and meshes are this machine's.
  bool sees_the_same_files() const {
    std::string key = task_.key;
    end_of(task_.deck, [&] {
      Diagnostics of_the_run;
      key = run_key(read_deck(task_.text, task_.deck, task_.overrides, of_the_run));
    });
    return key == task_.key;
  }

  std::string other_files_text() const {
    return fmt::format(
        "{} sees other particles or another mesh of {} than the first program: keep them where all "
        "machines see the same files",
        host_name(), std::filesystem::absolute(task_.deck).string());
  }

  void report() {
    RunRecord record{task_.key, {}};
    try {
      const auto done = crew_.take();
      if (!done) return;
      record = done->record;
    } catch (const FileError& error) {  // of the record, which a full disk does not take
      record.ending = {exit_file, error.what()};
    }
    box_.send({0, Errand::of_done(number_, record)});
  }

  void heed(int signal) {
    if (signal == SIGINT || signal == SIGTERM) crew_.tell(signal);
  }

  LetterBox& box_;
  SignalWatch watch_{SIGINT, SIGTERM, SIGCHLD};
  LocalCrew crew_{1};
  RunTask task_;
  long long number_ = -1;  // of the run under way, or the last one
};

}  // namespace

int serve(LetterBox& box, const std::string& program) {
  box.send({0, Errand::of_hello(program)});
  const Ending ending = end_of("tether", [&box] { Server(box).serve(); });
  std::fputs(ending.message.c_str(), stderr);
  return ending.exit_code;
}

}  // namespace tether
