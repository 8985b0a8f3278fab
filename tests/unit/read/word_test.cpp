// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/values.hpp"

#include <gtest/gtest.h>

#include "deck/reader.hpp"
#include "model/flow.hpp"
#include "model/method.hpp"

namespace tether {
namespace {

Deck deck_of(const std::string& groups) {
  Diagnostics diagnostics;
  return read_deck("$in\nnx=2,ny=2,xleft=0.,xright=1.,ybot=0.,ytop=1.,tmax=1.,tstep=1. $\n" + groups, "a.in", {},
                   diagnostics);
}

TEST(Word, IsTheEnumeratorOfTheDecksText) {
  EXPECT_EQ(word<Systems>(deck_of("$coupled solver='KRYLOV' $\n"), "coupled.solver"), Systems::krylov);
  EXPECT_EQ(word<Systems>(deck_of(""), "coupled.solver"), Systems::automatic);
}

TEST(Word, OfAVariableThatIsNotGivenIsWhatTheReaderSays) {
  EXPECT_EQ(word_or(deck_of("$mpm order='usl' $\n"), "mpm.order", StressOrder::usf), StressOrder::usl);
  EXPECT_EQ(word_or(deck_of(""), "mpm.order", StressOrder::usf), StressOrder::usf);
}

TEST(Word, OfAnotherEnumerationIsAMistakeOfTheProgram) {
  EXPECT_THROW(word<StressOrder>(deck_of("$coupled solver='direct' $\n"), "coupled.solver"), std::logic_error);
}

}  // namespace
}  // namespace tether
