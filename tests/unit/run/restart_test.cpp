// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/restart.hpp"

#include <gtest/gtest.h>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "run/outputs.hpp"
#include "unit/temporary_folder.hpp"

namespace tether {
namespace {

class CheckpointFor : public test::TemporaryFolder {
 protected:
  std::filesystem::path checkpoint_of(const std::string& deck) const {
    Checkpoint checkpoint;
    checkpoint.deck_effective = deck;
    checkpoint.records = {{0}};
    write_checkpoint(folder / "c.nc", checkpoint);
    return folder / "c.nc";
  }
  std::vector<std::string> differences(const std::string& before, const std::string& now) const {
    std::vector<std::string> texts;
    try {
      checkpoint_for(checkpoint_of(before), now);
    } catch (const InputError& error) {
      for (const auto& diagnostic : error.diagnostics()) texts.push_back(diagnostic.message);
    }
    return texts;
  }
};

TEST_F(CheckpointFor, TheSameDeckIsRead) {
  EXPECT_TRUE(differences("$in nx=3 $", "other title\n$in nx=3 $").empty());
  EXPECT_EQ(checkpoint_for(folder / "c.nc", "$in nx=3 $").deck_effective, "$in nx=3 $");
}

TEST_F(CheckpointFor, TheEndAndTheOutputsMayDiffer) {
  EXPECT_TRUE(
      differences("$in nx=3,tmax=1.,iout(33)=1,tiout(33)=.1 $", "$in nx=3,tmax=2.,iout(13)=1,tiout(13)=.2 $").empty());
}

TEST_F(CheckpointFor, VariablesWithoutEffectMayDiffer) {
  EXPECT_TRUE(differences("$in nx=3,miter=3 $", "$in nx=3,miter=4 $").empty());
}

TEST_F(CheckpointFor, EveryOtherDifferenceIsTold) {
  EXPECT_EQ(differences("$in nx=3,ny=4 $\n$reg nreg=1,rix(1)=2. $", "$in nx=5,ny=4,gravc=1. $"),
            (std::vector<std::string>{"in.nx was 3 in the run of the checkpoint and is 5 in the deck",
                                      "in.gravc was 0.0 in the run of the checkpoint and is 1.0 in the deck",
                                      "reg.nreg was 1 in the run of the checkpoint and is 0 in the deck",
                                      "reg.rix(1) was 2.0 in the run of the checkpoint and is 0.0 in the deck",
                                      "a restart goes on with the same deck"}));
}

TEST_F(CheckpointFor, ParticleDataMustBeTheSame) {
  const auto found = differences("$in nx=3 $\n1 2 3\n", "$in nx=3 $\n1 2 4\n");
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0], "the particle data are not those of the checkpoint's run");
}

class Offer : public CheckpointFor {
 protected:
  void add(const std::string& deck, double time) const {
    Checkpoint checkpoint;
    checkpoint.deck_effective = deck;
    checkpoint.time = time;
    checkpoint.records = {{0}};
    add_checkpoint(folder, checkpoint);
  }
  std::string refusal(const std::filesystem::path& path, const std::string& deck) const {
    try {
      checkpoint_for(path, deck);
    } catch (const FileError& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(Offer, OfTheOlderForADamagedOne) {
  add("$in nx=3 $", 0.3);
  add("$in nx=3 $", 0.4);
  const auto damaged = folder / "checkpoint-2.nc", older = folder / "checkpoint-1.nc";
  std::string bytes = read_file(damaged);
  bytes[400] = static_cast<char>(bytes[400] ^ 1);
  write_file(damaged, bytes);
  EXPECT_EQ(refusal(damaged, "$in nx=3 $"),
            damaged.string() + ": it is damaged: its checksum does not fit; checkpoint-1.nc is whole, of t = 0.3: " +
                "--restart " + older.string());
  EXPECT_EQ(refusal(damaged, "$in nx=4 $").find("is whole"), std::string::npos);
  EXPECT_EQ(refusal(folder, "$in nx=3 $"),
            folder.string() + ": is a folder; checkpoint-1.nc is whole, of t = 0.3: " + "--restart " + older.string());
  write_file(older, bytes);
  EXPECT_EQ(refusal(damaged, "$in nx=3 $").find("is whole"), std::string::npos);
}

TEST_F(CheckpointFor, AnEndBeforeItIsRefused) {
  Checkpoint checkpoint;
  checkpoint.deck_effective = "$in nx=3,tmax=2. $";
  checkpoint.time = 1.5;
  checkpoint.records = {{0}};
  write_checkpoint(folder / "c.nc", checkpoint);
  EXPECT_NO_THROW(checkpoint_for(folder / "c.nc", "$in nx=3,tmax=1.5 $"));
  EXPECT_THROW(checkpoint_for(folder / "c.nc", "$in nx=3,tmax=1.4 $"), InputError);
}

TEST_F(CheckpointFor, TheColumnsOfTheHistoryMustAgree) {
  EXPECT_EQ(differences("$in nx=3,iout(38)=1,tiout(38)=.1 $", "$in nx=3 $"),
            (std::vector<std::string>{"in.iout(38) was 1 in the run of the checkpoint and is 0 in the deck",
                                      "a restart goes on with the same deck"}));
  EXPECT_TRUE(differences("$in nx=3,iout(38)=0 $", "$in nx=3 $").empty());
}

TEST(Due, EveryMultipleOfTheInterval) {
  Due due(0.25);
  EXPECT_FALSE(due.passed(0.2));
  EXPECT_TRUE(due.passed(0.25));
  EXPECT_FALSE(due.passed(0.3));
  EXPECT_TRUE(due.passed(0.8));  // .5 and .75 at once
  EXPECT_NEAR(due.next(), 1, 1e-8);
}

TEST(Due, NeverForNoInterval) {
  Due due(0);
  EXPECT_FALSE(due.passed(1e300));
}

TEST(Due, GoesOnAsSaved) {
  Due due(0.25);
  EXPECT_TRUE(due.passed(0.6));
  Due same(0.25), other(0.1);
  same.restore(due.save(), 0.6);
  other.restore(due.save(), 0.6);
  EXPECT_EQ(same.next(), due.next());
  EXPECT_NEAR(other.next(), 0.7, 1e-8);
}

}  // namespace
}  // namespace tether
