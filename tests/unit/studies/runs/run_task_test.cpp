// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/runs/run_task.hpp"

#include <gtest/gtest.h>

#include "base/diagnostics.hpp"
#include "studies/runs/errand.hpp"

namespace tether {
namespace {

TEST(RunTask, IsTheSameAfterItWasSent) {
  const RunTask task{.deck = "a deck's \"name\".in",
                     .text = "$in\nnx=3\n$\n",
                     .overrides = {"in.nx=4", "in.particles='a b'"},
                     .key = std::string(64, 'f'),
                     .folder = "out/runs/ff",
                     .sign = "out/lock",
                     .threads = 3};
  const RunTask sent = task_of(text_of(task));
  EXPECT_EQ(sent.deck, task.deck);
  EXPECT_EQ(sent.text, task.text);
  EXPECT_EQ(sent.overrides, task.overrides);
  EXPECT_EQ(sent.key, task.key);
  EXPECT_EQ(sent.folder, task.folder);
  EXPECT_EQ(sent.sign, task.sign);
  EXPECT_EQ(sent.threads, 3);
  EXPECT_EQ(sent.most_cpu_seconds, task.most_cpu_seconds);
  EXPECT_THROW(task_of(text_of(task).substr(0, 100)), FileError);
}

TEST(RunRecord, IsTheSameAfterItWasSent) {
  const RunRecord record{"k", {exit_run, "t = 1: it diverged", Failure::loses_points}, 0.1, 1. / 3};
  const RunRecord sent = record_of(text_of(record));
  EXPECT_EQ(sent.key, "k");
  EXPECT_EQ(sent.ending.exit_code, exit_run);
  EXPECT_EQ(sent.ending.message, record.ending.message);
  EXPECT_EQ(sent.ending.failure, Failure::loses_points);
  EXPECT_EQ(sent.cpu_seconds, 0.1);
  EXPECT_EQ(sent.wall_seconds, 1. / 3);
  EXPECT_FALSE(record_of(text_of({"k", {exit_done, ""}, 0, 0})).ending.failure);
}

TEST(Errand, IsReadAsItWasWritten) {
  const Errand errand(Errand::of_blind(1LL << 40, "nothing is seen"));
  EXPECT_EQ(errand.kind(), ErrandKind::blind);
  EXPECT_EQ(errand.number(), 1LL << 40);
  EXPECT_EQ(errand.text(), "nothing is seen");
  for (const char* text : {"", "4:none1:02:xx", "hello"}) EXPECT_THROW(Errand{text}, FileError);
}

}  // namespace
}  // namespace tether
