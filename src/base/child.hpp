// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/resource.h>
#include <sys/types.h>

#include <functional>
#include <optional>
#include <string>

namespace tether {

/// Has the kernel end this process, made by fork(), when its parent ends. False where that has been already.
bool end_with_parent(pid_t parent);
/// Returns what a process had of the processor, in its own code and in the kernel [seconds].
double processor_seconds(const rusage& usage) noexcept;

/// Does work in a process of its own, made by fork(), and returns the bytes that the work does; nothing where it
/// crashed or threw; what it prints is not shown. What it does to memory is lost with it: for libraries that spoil it
/// where they fail. The work calls no threads. Throws RunError where no process can be started.
std::optional<std::string> from_a_child(const std::function<std::string()>& work);

}  // namespace tether
