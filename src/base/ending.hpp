// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

namespace tether {

// Exit codes of the contract; a signal's is 128 + its number.
constexpr int exit_done = 0, exit_input = 2, exit_run = 3, exit_file = 4, exit_verdict = 5, exit_signal = 128;

/// How a piece of work ended: the contract's exit code, and what there is to say of it ("" where all went well).
struct Ending {
  int exit_code = exit_done;
  std::string message;
};

/// Does the work; what it throws becomes the exit code and the message, which begins with `name` unless it names its
/// file itself, and ends with a line end.
Ending end_of(const std::string& name, const std::function<void()>& work);

}  // namespace tether
