// SPDX-License-Identifier: GPL-3.0-or-later
#include "loops/instruction_set.hpp"

#include <hwy/targets.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <string_view>

#include "base/diagnostics.hpp"

namespace tether {
namespace {

struct Row {
  std::string_view word;
  InstructionSet set;
  std::int64_t needs;  // of Highway's bits, 0: nothing
};

/// From the best one on.
constexpr std::array rows{
    Row{"avx512", InstructionSet::avx512, HWY_AVX3},
    Row{"avx2", InstructionSet::avx2, HWY_AVX2},
    Row{"sse2", InstructionSet::sse2, HWY_SSSE3},
    Row{"one", InstructionSet::one, 0},
};

bool is_there(const Row& row) { return row.needs == 0 || (hwy::SupportedTargets() & row.needs) != 0; }

InstructionSet best() {
  for (const Row& row : rows) {
    if (is_there(row)) return row.set;
  }
  return InstructionSet::one;
}

}  // namespace

bool has(InstructionSet set) {
  return std::any_of(rows.begin(), rows.end(), [set](const Row& row) { return row.set == set && is_there(row); });
}

InstructionSet instruction_set() {
  const char* asked = std::getenv("TETHER_TARGET");  // NOLINT(concurrency-mt-unsafe): no thread changes it
  if (!asked || !*asked) return best();
  for (const Row& row : rows) {
    if (row.word != asked) continue;
    if (is_there(row)) return row.set;
    throw InputError("TETHER_TARGET=" + std::string(asked) + ": this processor has no such instructions");
  }
  throw InputError("TETHER_TARGET=" + std::string(asked) + " is no set of instructions",
                   "avx512, avx2, sse2 or one; without it the processor's best is taken");
}

}  // namespace tether
