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
  bool is_built;  // passes by lanes are compiled for it
  bool (*is_there)();
};

#ifdef TETHER_SSE
constexpr bool has_sse_lanes = true;
#else
constexpr bool has_sse_lanes = false;
#endif

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
    Row{"avx512", InstructionSet::avx512, true, has_avx512},
    Row{"avx2", InstructionSet::avx2, true, has_avx2},
    Row{"sse2", InstructionSet::sse2, has_sse_lanes, has_ssse3},
    Row{"one", InstructionSet::one, true, [] { return true; }},
};
constexpr std::string_view words_of_sets = has_sse_lanes ? "avx512, avx2, sse2 or one" : "avx512, avx2 or one";

InstructionSet best() {
  for (const Row& row : rows) {
    if (row.is_built && row.is_there()) return row.set;
  }
  return InstructionSet::one;
}

}  // namespace

bool has(InstructionSet set) {
  return std::any_of(rows.begin(), rows.end(),
                     [set](const Row& row) { return row.set == set && row.is_built && row.is_there(); });
}

InstructionSet instruction_set() {
  const char* asked = std::getenv("TETHER_TARGET");  // NOLINT(concurrency-mt-unsafe): no thread changes it
  if (!asked || !*asked) return best();
  const std::string setting = "TETHER_TARGET=" + std::string(asked);
  const auto row = std::find_if(rows.begin(), rows.end(), [asked](const Row& each) { return each.word == asked; });
  if (row == rows.end())
    throw InputError(setting + " is no set of instructions",
                     std::string(words_of_sets) + "; without it the processor's best is taken");
  if (!row->is_built)
    throw InputError(setting + ": this program was built without these instructions",
                     "build it again after cmake -DTETHER_SSE=ON, or take " + std::string(words_of_sets));
  if (!row->is_there()) throw InputError(setting + ": this processor has no such instructions");
  return row->set;
}

}  // namespace tether
