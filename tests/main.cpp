// SPDX-License-Identifier: GPL-3.0-or-later
// Begins the test programs as main.cpp of src/ begins runs: memory that steps free is kept for the next ones, and
// CHOLMOD starts no threads.
#include <gtest/gtest.h>
#include <omp.h>

#include "base/process.hpp"

int main(int count, char** words) {
  tether::keep_freed_memory();
  omp_set_max_active_levels(0);
  testing::InitGoogleTest(&count, words);
  return RUN_ALL_TESTS();
}
