// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace tether {

/// What a user may have meant by a variable that $group does not have: the group that has it, or the nearest name
/// (first of the same group); empty if nothing is near. Both in lower case.
std::string suggest_variable(const std::string& group, const std::string& name);

/// The variable "group.name" that such a suggestion means by another name; empty where there is none.
std::string meant_variable(const std::string& group, const std::string& name);

/// What a user may have meant by an unknown group: the nearest one, or else all of them.
std::string suggest_group(const std::string& name);

}  // namespace tether
