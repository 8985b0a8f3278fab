// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <set>

#include "base/file.hpp"
#include "base/process.hpp"
#include "deck/reader.hpp"
#include "plan/load.hpp"
#include "results/summary_keys.hpp"
#include "run/run.hpp"
#include "studies/run_record.hpp"
#include "studies/scheduler.hpp"
#include "unit/temporary_folder.hpp"

namespace tether {
namespace {

class Records : public test::TemporaryFolder {};

TEST_F(Records, ReadBackAsTheyWereWritten) {
  write_record(folder / "a", {"k1", {exit_run, "t = 1, step 2: key = value"}, 0.1, 1.0 / 3});
  const auto record = read_record(folder / "a", "k1");
  ASSERT_TRUE(record);
  EXPECT_EQ(record->ending.exit_code, exit_run);
  EXPECT_EQ(record->ending.message, "t = 1, step 2: key = value");
  EXPECT_EQ(record->cpu_seconds, 0.1);
  EXPECT_EQ(record->wall_seconds, 1.0 / 3);
}

TEST_F(Records, OfAnotherRunOrBrokenOrMissingAreNone) {
  EXPECT_FALSE(read_record(folder, "k1"));
  write_record(folder, {"k1", {exit_run, ""}, 0, 0});
  EXPECT_TRUE(read_record(folder, "k1"));
  EXPECT_FALSE(read_record(folder, "k2"));
  for (const char* text : {"", "key = k1\n", "key = k1\nexit_code = x\ncpu_seconds = 0\nwall_seconds = 0\n"}) {
    write_file(folder / "run.txt", text);
    EXPECT_FALSE(read_record(folder, "k1")) << text;
  }
}

TEST_F(Records, AGoodRunNeedsItsSummary) {
  write_record(folder, {"k1", {exit_done, ""}, 0, 0});
  EXPECT_FALSE(read_record(folder, "k1"));
  write_file(folder / "summary.txt", "steps = 1\n");
  EXPECT_FALSE(read_record(folder, "k1"));
  write_record(folder, {"k1", {exit_done, ""}, 0, 0});
  EXPECT_TRUE(read_record(folder, "k1"));
  write_file(folder / "summary.txt", "");
  EXPECT_FALSE(read_record(folder, "k1"));
}

TEST_F(Records, AGoodRunNeedsItsWholeHistory) {
  const std::string history = "# time\n0\n1\n";
  write_file(folder / "summary.txt", "steps = 1\n");
  write_file(folder / "history.txt", history);
  write_record(folder, {"k1", {exit_done, ""}, 0, 0});
  EXPECT_TRUE(read_record(folder, "k1"));
  write_file(folder / "history.txt", history.substr(0, history.size() - 2));
  EXPECT_FALSE(read_record(folder, "k1"));
  write_file(folder / "history.txt", history);
  EXPECT_TRUE(read_record(folder, "k1"));
  std::filesystem::remove(folder / "history.txt");
  EXPECT_FALSE(read_record(folder, "k1"));
}

TEST(OneLine, DropsCaretsAndLineEnds) {
  EXPECT_EQ(one_line("d.in:3:5: error: wrong\n  nx=1\n     ^\n  Allowed: 2.\n"),
            "d.in:3:5: error: wrong nx=1 Allowed: 2.");
  EXPECT_EQ(one_line(""), "");
}

TEST(RunKey, IsOfAllValuesAndTheParticleData) {
  const auto key = [](const std::vector<std::string>& overrides, const std::string& data) {
    Diagnostics ignored;
    return run_key(read_deck("$in\nigen=0\n$\n" + data, "d.in", overrides, ignored));
  };
  EXPECT_EQ(key({}, "1 2\n").size(), 64u);
  EXPECT_EQ(key({}, "1 2\n"), key({"in.gravc=0.0"}, "1 2\n"));  // its default
  const std::set<std::string> keys{key({}, "1 2\n"), key({"in.gravc=1"}, "1 2\n"), key({}, "1 3\n")};
  EXPECT_EQ(keys.size(), 3u);
}

/// Waits for the next that ends.
Finished next(Workers& workers, SignalWatch& watch) {
  for (;;) {
    if (auto finished = workers.take()) return *finished;
    watch.wait(1);
  }
}

TEST(Workers, BringBackCodesAndMessages) {
  SignalWatch watch{SIGCHLD};
  Workers workers;
  workers.start(7, [] { return Ending{exit_run, "it diverged\n"}; });
  EXPECT_EQ(workers.count(), 1u);
  const Finished finished = next(workers, watch);
  EXPECT_EQ(finished.id, 7u);
  EXPECT_EQ(finished.ending.exit_code, exit_run);
  EXPECT_EQ(finished.ending.message, "it diverged\n");
  EXPECT_EQ(workers.count(), 0u);
}

TEST(Workers, ACrashIsAnEndingLikeAnyOther) {
  SignalWatch watch{SIGCHLD};
  Workers workers;
  workers.start(1, []() -> Ending {
    std::raise(SIGKILL);
    return {};
  });
  const Finished finished = next(workers, watch);
  EXPECT_EQ(finished.ending.exit_code, 137);
  EXPECT_EQ(finished.ending.message, "killed by signal 9\n");
}

TEST(Workers, AVeryLongMessageIsCutAndBlocksNothing) {
  SignalWatch watch{SIGCHLD};
  Workers workers;
  workers.start(1, [] { return Ending{exit_input, std::string(1000000, 'x')}; });
  const Finished finished = next(workers, watch);
  EXPECT_EQ(finished.ending.exit_code, exit_input);
  EXPECT_EQ(finished.ending.message, std::string(4096, 'x'));
}

/// Every kind of scene with an exact solution, and one without: real runs write the keys that are foretold.
TEST_F(Records, SummariesHaveTheForetoldKeys) {
  std::set<ReferenceKind> kinds;
  for (const char* name :
       {"stability-side", "sod", "spring-mass", "string-mass", "pendulum-20", "piston-m1", "gas-expansion"}) {
    std::vector<std::string> overrides{"in.tmax=2e-3"};
    if (name == std::string("gas-expansion")) overrides.push_back("reference.solution='radial-gas'");
    const Loaded loaded = load(std::string(TETHER_SOURCE_DIR) + "/decks/" + name + ".in", {overrides, "", "mpm"});
    run(loaded.plan, request_of(loaded, folder / name, ""));
    std::vector<std::string> keys;
    std::size_t of_strings = 0, of_gases = 0, of_solids = 0;
    for (const auto& [key, value] : read_summary(folder / name / "summary.txt")) {
      if (key == string_summary_keys().front())
        ++of_strings;
      else if (key == gas_summary_keys().front())
        ++of_gases;
      else if (key == solid_points_summary_keys().front())
        ++of_solids;
      else
        keys.push_back(key);
    }
    EXPECT_EQ(of_strings > 0, find_body<Membrane>(loaded.plan.scene) != nullptr) << name;
    const Scene& scene = loaded.plan.scene;
    EXPECT_EQ(of_solids > 0, find_body<PlaneElastic>(scene) || find_body<LinearFluid>(scene)) << name;
    EXPECT_EQ(of_gases, name == std::string("sod") ? 1U : 0U) << name;
    EXPECT_EQ(keys, summary_keys(loaded.plan.scene.reference)) << name;
    kinds.insert(loaded.plan.scene.reference);
  }
  EXPECT_EQ(kinds.size(), 7u);
}

TEST_F(Records, SummariesOfMeshesHaveTheirKeysToo) {
  for (const char* name : {"l-block", "rigid-torque", "cavity"}) {
    const Loaded loaded = load(std::string(TETHER_SOURCE_DIR) + "/decks/" + name + ".in", {{"in.tmax=.3"}, "", ""});
    run(loaded.plan, request_of(loaded, folder / name, ""));
    std::set<std::string> keys;
    for (const auto& [key, value] : read_summary(folder / name / "summary.txt")) keys.insert(key);
    auto written = std::string(name) == "rigid-torque"
                       ? std::vector<std::string>{"unknowns", "newton_iterations", "halvings"}
                       : mesh_summary_keys();
    if (name == std::string("l-block")) {
      for (auto& key : body_summary_keys()) written.push_back(std::move(key));
    }
    if (loaded.plan.scene.flow()) {
      for (auto& key : flow_summary_keys()) written.push_back(std::move(key));
    }
    for (const auto& key : written) EXPECT_EQ(keys.count(key), 1u) << key << " of " << name;
  }
}

TEST_F(Records, SummariesOfBoxesHaveTheirs) {
  const std::vector<std::string> overrides{"in.tmax=.04", "coupled.mode='splitting'",
                                           "coupled.obstacle(1,1)=1.5,1.6,.5,.6", "coupled.void(1,1)=1.2,1.3,.7,.8"};
  const Loaded loaded = load(std::string(TETHER_SOURCE_DIR) + "/decks/coupled-bar.in", {overrides, "", ""});
  run(loaded.plan, request_of(loaded, folder / "bar", ""));
  std::set<std::string> keys;
  for (const auto& [key, value] : read_summary(folder / "bar/summary.txt")) keys.insert(key);
  for (const auto& key : coupled_summary_keys()) EXPECT_EQ(keys.count(key), 1u) << key;
  for (const auto& key : locking_summary_keys()) EXPECT_EQ(keys.count(key), 1u) << key;
  for (const auto& key : body_summary_keys()) EXPECT_EQ(keys.count(key), 1u) << key;
}

}  // namespace
}  // namespace tether
