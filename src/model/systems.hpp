// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/words.hpp"

namespace tether {

/// How linear systems are solved: as their size asks, by factors, or by an iteration.
enum class Systems { automatic, direct, krylov };
template <>
inline constexpr std::array<Word<Systems>, 3> words<Systems>{
    {{Systems::automatic, "auto"}, {Systems::direct, "direct"}, {Systems::krylov, "krylov"}}};

}  // namespace tether
