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
#include "studies/runs/run_record.hpp"
#include "studies/runs/workers.hpp"
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
  EXPECT_EQ(finished.ending.message, std::string(4095, 'x'));  // after the line of its failure
}

std::set<std::string> written(const std::filesystem::path& out) {
  std::set<std::string> keys;
  for (const auto& [key, value] : read_summary(out / "summary.txt")) keys.insert(key);
  return keys;
}

/// Keys that every run of this kind writes.
std::vector<std::string> always(unsigned kind) {
  std::vector<std::string> keys;
  for (const SummaryRow& row : summary_rows) {
    if ((row.of & kind) != 0 && row.when.empty()) keys.emplace_back(row.name);
  }
  return keys;
}

std::set<std::string> foretold(unsigned kind, ReferenceKind reference) {
  std::set<std::string> keys;
  for (auto& key : summary_keys(kind)) keys.insert(std::move(key));
  for (auto& key : figure_keys(reference)) keys.insert(std::move(key));
  return keys;
}

template <class Keys>
void expect_all(const Keys& wanted, const std::set<std::string>& there, const std::string& name) {
  for (const auto& key : wanted) EXPECT_TRUE(there.contains(key)) << key << " of " << name;
}

/// Every kind of scene with an exact solution, and one without: real runs write the keys that are foretold, no others.
TEST_F(Records, SummariesHaveTheForetoldKeys) {
  std::set<ReferenceKind> kinds;
  for (const char* name :
       {"stability-side", "sod", "spring-mass", "string-mass", "pendulum-20", "piston-m1", "gas-expansion"}) {
    std::vector<std::string> overrides{"in.tmax=2e-3"};
    if (name == std::string("gas-expansion")) overrides.push_back("reference.solution='radial-gas'");
    const Loaded loaded = load(std::string(TETHER_SOURCE_DIR) + "/decks/" + name + ".in", {overrides, "", "mpm"});
    run(loaded.plan, request_of(loaded, folder / name, ""));
    const Scene& scene = loaded.plan.scene;
    const std::set<std::string> keys = written(folder / name);
    EXPECT_EQ(keys.contains("widest_gap"), find_body<Membrane>(scene) != nullptr) << name;
    EXPECT_EQ(keys.contains("volume_worst"), find_body<PlaneElastic>(scene) || find_body<LinearFluid>(scene)) << name;
    EXPECT_EQ(keys.contains("gases_apart"), name == std::string("sod")) << name;
    expect_all(always(runs_of::points), keys, name);
    expect_all(figure_keys(scene.reference), keys, name);
    expect_all(keys, foretold(runs_of::points, scene.reference), name);
    kinds.insert(scene.reference);
  }
  EXPECT_EQ(kinds.size(), 7u);
}

TEST_F(Records, SummariesOfMeshesHaveTheirKeysToo) {
  const std::array<std::pair<const char*, unsigned>, 4> decks{{{"l-block", runs_of::solids},
                                                               {"rigid-torque", runs_of::rigid},
                                                               {"cavity", runs_of::flows},
                                                               {"two-flaps", runs_of::flows}}};
  for (const auto& [name, kind] : decks) {
    const Loaded loaded = load(std::string(TETHER_SOURCE_DIR) + "/decks/" + name + ".in", {{"in.tmax=.01"}, "", ""});
    run(loaded.plan, request_of(loaded, folder / name, ""));
    const std::set<std::string> keys = written(folder / name);
    expect_all(always(kind), keys, name);
    expect_all(keys, foretold(kind, ReferenceKind::none), name);
    EXPECT_EQ(keys.contains("cells_across"), name == std::string("two-flaps"));
  }
}

TEST_F(Records, SummariesOfBoxesHaveTheirs) {
  const std::vector<std::string> overrides{"in.tmax=.04", "coupled.mode='splitting'",
                                           "coupled.obstacle(1,1)=1.5,1.6,.5,.6", "coupled.void(1,1)=1.2,1.3,.7,.8"};
  const Loaded loaded = load(std::string(TETHER_SOURCE_DIR) + "/decks/coupled-bar.in", {overrides, "", ""});
  run(loaded.plan, request_of(loaded, folder / "bar", ""));
  const std::set<std::string> keys = written(folder / "bar");
  expect_all(always(runs_of::boxes), keys, "bar");
  expect_all(std::vector<std::string>{"added_mass_ratio", "obstacle_volume", "void_volume", "elements_across",
                                      "quality_least"},
             keys, "bar");
  expect_all(keys, foretold(runs_of::boxes, ReferenceKind::none), "bar");
}

}  // namespace
}  // namespace tether
