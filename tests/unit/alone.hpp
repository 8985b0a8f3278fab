// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/team.hpp"

namespace tether {

/// A team of the caller alone.
inline Team& alone() {
  static Team team;
  return team;
}

}  // namespace tether
