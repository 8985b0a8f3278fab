// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tether {

/// What lanes a loop may use: eight, four, two or a single one. Results do not depend on it.
enum class InstructionSet { one, sse2, avx2, avx512 };

constexpr InstructionSet instruction_sets[] = {InstructionSet::one, InstructionSet::sse2, InstructionSet::avx2,
                                               InstructionSet::avx512};

/// Returns whether the processor has it, and the program was built for it: sse2 by TETHER_SSE alone.
bool has(InstructionSet set);

/// The one that TETHER_TARGET in the environment asks for, else the processor's best. Throws InputError where it asks
/// for what there is not.
InstructionSet instruction_set();

}  // namespace tether
