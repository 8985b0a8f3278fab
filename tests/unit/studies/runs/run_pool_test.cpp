// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/runs/run_pool.hpp"

#include <gtest/gtest.h>

#include "base/file.hpp"
#include "studies/runs/local_crew.hpp"
#include "unit/temporary_folder.hpp"

namespace tether {
namespace {

/// A run of a body that turns, with these values.
StudyRun run_of(const std::filesystem::path& out, const std::vector<std::string>& sets) {
  StudyRun run;
  run.study.file = TETHER_SOURCE_DIR "/decks/rigid-free.in";
  run.study.text = read_file(run.study.file);
  run.study.decks = {{1, run.study.file, run.study.text}};
  run.study.sets = sets;
  run.out = out;
  return run;
}

class RunPool : public test::TemporaryFolder {};

TEST_F(RunPool, StopsARunThatTakesMoreOfTheProcessorThanItMay) {
  StudyRun quick = run_of(folder / "quick", {"in.tmax=.1"});
  StudyRun slow = run_of(folder / "slow", {"in.tmax=20.", "in.tstep=1.e-8"});
  slow.most_cpu_seconds = 1;
  LocalCrew crew(2);
  const auto ends =
      run_each({quick, slow}, {.out = folder, .crew = crew, .threads = 1, .command = "a test", .progress = {}});
  EXPECT_EQ(ends[0].ending.exit_code, exit_done) << ends[0].ending.message;
  EXPECT_NE(ends[1].ending.exit_code, exit_done);
  EXPECT_NE(ends[1].ending.message.find("as much of the processor as it may"), std::string::npos)
      << ends[1].ending.message;
}

}  // namespace
}  // namespace tether
