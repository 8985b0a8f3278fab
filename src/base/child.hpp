// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/resource.h>
#include <sys/types.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tether {

/// Has the kernel end this process, made by fork(), when its parent ends. False where that has been already.
bool end_with_parent(pid_t parent);
/// Returns what a process had of the processor, in its own code and in the kernel [seconds].
double processor_seconds(const rusage& usage) noexcept;

/// Does work in a process of its own, made by fork(), and returns the bytes that the work does; nothing where it
/// crashed or threw; what it prints is not shown. What it does to memory is lost with it: for libraries that spoil it
/// where they fail. The work calls no threads. Throws RunError where no process can be started.
std::optional<std::string> from_a_child(const std::function<std::string()>& work);

/// Runs a program, which is looked for in PATH, without a shell between; `words` begin with its name. Returns its exit
/// code, -1 where a signal ended it, 127 where there is no such program, and what it says to both of its outputs.
/// Throws FileError where no process can be started.
std::pair<int, std::string> said_by(std::vector<std::string> words);

}  // namespace tether
