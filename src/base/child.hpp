// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace tether {

/// Does work in a process of its own, made by fork(), and returns the bytes that the work does; nothing where it
/// crashed or threw. What it does to memory is lost with it: for libraries that spoil it where they fail. The work
/// calls no threads. Throws RunError where no process can be started.
std::optional<std::string> from_a_child(const std::function<std::string()>& work);

}  // namespace tether
