// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/cluster/slurm.hpp"

#include <gtest/gtest.h>

#include <set>

namespace tether::slurm {
namespace {

std::vector<PartCost> parts_of(std::size_t count, double seconds) {
  std::vector<PartCost> parts;
  for (std::size_t number = 1; number <= count; ++number)
    parts.push_back({number, seconds, 10.0 * static_cast<double>(number)});
  return parts;
}

/// All parts once, whatever job they are in.
void expect_all(const std::vector<Job>& jobs, std::size_t count) {
  std::set<std::size_t> numbers;
  std::size_t all = 0;
  for (const Job& job : jobs) numbers.insert(job.parts.begin(), job.parts.end()), all += job.parts.size();
  EXPECT_EQ(numbers.size(), count);
  EXPECT_EQ(all, count);
}

TEST(SlurmJobs, OfShortPartsTakeAMinute) {
  const auto jobs = jobs_of(parts_of(100, 7));
  expect_all(jobs, 100);
  EXPECT_EQ(jobs.size(), 12u);  // of nine parts, 63 s, the last of one
  for (std::size_t k = 0; k + 1 < jobs.size(); ++k) EXPECT_GE(jobs[k].seconds, 60);
  EXPECT_EQ(jobs.front().megabytes, 90);
}

TEST(SlurmJobs, OfLongPartsHaveOneEachTheLongestFirst) {
  auto parts = parts_of(3, 100);
  parts[1].seconds = 1000;
  const auto jobs = jobs_of(parts);
  ASSERT_EQ(jobs.size(), 3u);
  EXPECT_EQ(jobs[0].parts, std::vector<std::size_t>{2});
}

TEST(SlurmJobs, AreNoMoreThanAnArrayTakes) {
  for (const double seconds : {0., 1., 500.}) {
    const auto jobs = jobs_of(parts_of(10'000, seconds));
    expect_all(jobs, 10'000);
    EXPECT_LE(jobs.size(), 1001u) << seconds;
  }
}

TEST(SlurmScript, HasNothingOfAUsersInWhatSbatchReads) {
  const std::string odd = "a b'c\n#SBATCH --uid=0\n$(date)";
  const Work work{
      .folder = "/shared/" + odd, .here = "/decks/" + odd, .command = {"/bin/tether", "sweep", odd}, .cpus = 3};
  const std::string script = script_of(work, jobs_of(parts_of(2, 100)));
  const std::string heading = script.substr(0, script.find("parts=("));
  EXPECT_EQ(heading.find("a b"), std::string::npos);
  EXPECT_NE(heading.find("#SBATCH --array=1-2\n"), std::string::npos);
  EXPECT_NE(heading.find("#SBATCH --cpus-per-task=3\n"), std::string::npos);
  EXPECT_NE(heading.find("#SBATCH --time=14\n"), std::string::npos);  // minutes: twice 100 s, and ten more
  EXPECT_NE(script.find("/bin/tether sweep 'a b'\\''c\n#SBATCH --uid=0\n$(date)' --part"), std::string::npos) << script;
}

TEST(PartNumbers, AreReadAndWritten) {
  EXPECT_EQ(part_numbers("3,7-9"), (std::set<std::size_t>{3, 7, 8, 9}));
  EXPECT_EQ(part_numbers("1"), std::set<std::size_t>{1});
  EXPECT_EQ(part_text({3, 7, 8, 9, 11}), "3,7-9,11");
  for (const char* text : {"", ",", "0", "1,", "3-2", "a", "-1", "1--2", "1.5", "1-99999999999999999999"})
    EXPECT_FALSE(part_numbers(text)) << text;
}

}  // namespace
}  // namespace tether::slurm
