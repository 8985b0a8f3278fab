// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/words.hpp"
#include "studies/runs/run_task.hpp"

namespace tether {

enum class ErrandKind {
  hello,   ///< what this program is
  run,     ///< do this run
  signal,  ///< send this signal to the run
  done,    ///< the run has ended, with this record
  blind    ///< the studies' folder, or a file of the run, is not seen as the first program sees it, says this message
};
template <>
inline constexpr std::array<Word<ErrandKind>, 5> words<ErrandKind>{{{ErrandKind::hello, "hello"},
                                                                    {ErrandKind::run, "run"},
                                                                    {ErrandKind::signal, "signal"},
                                                                    {ErrandKind::done, "done"},
                                                                    {ErrandKind::blind, "blind"}}};

/// What one program of a command asks of another, or reports to it: of which run, and what.
class Errand {
 public:
  /// Reads one. Throws FileError where the text is none.
  explicit Errand(const std::string& letter);

  ErrandKind kind() const { return kind_; }
  /// The run's number, which its sender has given it.
  long long number() const { return number_; }
  /// A program, a task, a record, a signal's number or a message, as a text.
  const std::string& text() const { return text_; }

  // Each as the text of a letter.
  static std::string of_hello(const std::string& program);
  static std::string of_run(long long number, const RunTask& task);
  static std::string of_signal(long long number, int signal);
  static std::string of_done(long long number, const RunRecord& record);
  static std::string of_blind(long long number, const std::string& message);

 private:
  ErrandKind kind_ = ErrandKind::blind;
  long long number_ = 0;
  std::string text_;
};

}  // namespace tether
