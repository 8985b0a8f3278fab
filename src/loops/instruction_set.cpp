// SPDX-License-Identifier: GPL-3.0-or-later
#include "loops/instruction_set.hpp"

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
  bool (*is_there)();
};

// What Highway compiles for each. Its own library asks the processor, too, but times it as well whenever it is loaded.
bool has_ssse3() { return __builtin_cpu_supports("ssse3"); }
bool has_avx2() {
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
         __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("f16c");
}
bool has_avx512() {
  return has_avx2() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
         __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd");
}

/// From the best one on.
constexpr std::array rows{
    Row{"avx512", InstructionSet::avx512, has_avx512},
    Row{"avx2", InstructionSet::avx2, has_avx2},
    Row{"sse2", InstructionSet::sse2, has_ssse3},
    Row{"one", InstructionSet::one, [] { return true; }},
};

InstructionSet best() {
  for (const Row& row : rows) {
    if (row.is_there()) return row.set;
  }
  return InstructionSet::one;
}

}  // namespace

bool has(InstructionSet set) {
  return std::any_of(rows.begin(), rows.end(), [set](const Row& row) { return row.set == set && row.is_there(); });
}

InstructionSet instruction_set() {
  const char* asked = std::getenv("TETHER_TARGET");  // NOLINT(concurrency-mt-unsafe): no thread changes it
  if (!asked || !*asked) return best();
  for (const Row& row : rows) {
    if (row.word != asked) continue;
    if (row.is_there()) return row.set;
    throw InputError("TETHER_TARGET=" + std::string(asked) + ": this processor has no such instructions");
  }
  throw InputError("TETHER_TARGET=" + std::string(asked) + " is no set of instructions",
                   "avx512, avx2, sse2 or one; without it the processor's best is taken");
}

}  // namespace tether
