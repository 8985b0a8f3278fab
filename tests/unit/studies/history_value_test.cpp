// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/history_value.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "unit/temporary_folder.hpp"

namespace tether {
namespace {

using Numbers = std::vector<double>;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// "column: message" of the first mistake, "" where there is none.
std::string mistake(const std::string& text) {
  const auto mistakes = read_history_value(text).mistakes;
  return mistakes.empty() ? "" : std::to_string(mistakes[0].column) + ": " + mistakes[0].message;
}

HistoryValue value(const std::string& text) { return read_history_value(text).value; }

TEST(HistoryValue, IsAFunctionOfAColumn) {
  for (const char* text : {"time_of_max(body_vx_12)", " time_of_max ( body_vx_12 ) "}) {
    EXPECT_TRUE(is_history_value(text));
    EXPECT_EQ(mistake(text), "");
    EXPECT_EQ(value(text).function, "time_of_max");
    EXPECT_EQ(value(text).column, "body_vx_12");
    EXPECT_EQ(value(text).name(), "time_of_max_body_vx_12");
  }
  EXPECT_EQ(value("last( dt)").at, 7);
  EXPECT_EQ(value("min(energy_total)").meaning(), "least record of energy_total in history.txt");
}

TEST(HistoryValue, AKeyOfTheSummaryIsNone) {
  EXPECT_FALSE(is_history_value("error_period"));
  EXPECT_FALSE(is_history_value(""));
}

TEST(HistoryValue, MistakesAtTheirColumns) {
  EXPECT_EQ(mistake("lst(time)"), "1: there is no function 'lst' of a column of history.txt");
  EXPECT_EQ(mistake("(time)"), "1: there is no function '' of a column of history.txt");
  EXPECT_EQ(mistake("last(time"), "5: this bracket is not closed");
  EXPECT_EQ(mistake("last time)"), "10: nothing opens this bracket");
  EXPECT_EQ(mistake(")last("), "1: nothing opens this bracket");
  EXPECT_EQ(mistake("last(time) + 1"), "11: something stands after the bracket");
  EXPECT_EQ(mistake("last()"), "6: '' is no name of a column of history.txt");
  EXPECT_EQ(mistake("last( body vx )"), "7: 'body vx' is no name of a column of history.txt");
  EXPECT_EQ(mistake("last(max(time))"), "15: something stands after the bracket");
  EXPECT_EQ(mistake("last(a\"b)"), "6: 'a\"b' is no name of a column of history.txt");
}

TEST(HistoryValue, HintsNameWhatWasMeant) {
  EXPECT_EQ(read_history_value("lats(time)").mistakes[0].hint, "Did you mean 'last'?");
  EXPECT_EQ(read_history_value("average(time)").mistakes[0].hint,
            "There are first, last, max, min, time_of_max, time_of_min.");
}

TEST(HistoryNumber, EachFunction) {
  const Numbers times{0, 1, 2, 3, 4}, column{2, 5, -1, 5, -1};
  const auto number = [&](const char* text) { return number_of(value(text), times, column); };
  EXPECT_EQ(number("last(a)"), -1);
  EXPECT_EQ(number("max(a)"), 5);
  EXPECT_EQ(number("min(a)"), -1);
  EXPECT_EQ(number("time_of_max(a)"), 1);  // of equals the first
  EXPECT_EQ(number("time_of_min(a)"), 2);
}

TEST(HistoryNumber, IsNoneWhereTheColumnHasNone) {
  for (const Numbers& column : {Numbers{}, Numbers{1, none, 2}}) {
    EXPECT_TRUE(std::isnan(number_of(value("max(a)"), {0, 1, 2}, column)));
    EXPECT_TRUE(std::isnan(number_of(value("last(a)"), {0, 1, 2}, column)));
  }
}

class HistoryFile : public test::TemporaryFolder {
 protected:
  HistoryNumbers read(const std::string& text, const std::vector<std::string>& wanted) {
    write_file(folder / "history.txt", text);
    std::vector<HistoryValue> values;
    for (const auto& each : wanted) values.push_back(value(each));
    return read_history_numbers(folder / "history.txt", values);
  }
};

TEST_F(HistoryFile, GivesTheValuesByTheirNames) {
  const auto numbers = read("# time dt body_x_1 body_x_2\n0 1e-3 0.1 -7\n0.5 1e-4 0.30000000000000004 -8e-300\n",
                            {"last(body_x_1)", "min(body_x_2)", "time_of_min(dt)", "last(time)"});
  const std::map<std::string, double> expected{
      {"last_body_x_1", 0.30000000000000004}, {"min_body_x_2", -7}, {"time_of_min_dt", 0.5}, {"last_time", 0.5}};
  EXPECT_EQ(numbers.values, expected);
  EXPECT_TRUE(numbers.lacking.empty());
}

TEST_F(HistoryFile, ColumnsThatAreNotThere) {
  const auto numbers = read("# time body_vx_1 body_vx_2\n0 1 2\n", {"last(body_vx_3)", "max(nothing_of_it)"});
  EXPECT_TRUE(numbers.values.empty());
  EXPECT_EQ(numbers.lacking.at("body_vx_3"), "Did you mean 'body_vx_1'?");
  EXPECT_EQ(numbers.lacking.at("nothing_of_it"), "There are time, body_vx_1, body_vx_2.");
}

TEST_F(HistoryFile, HundredsOfColumnsDoNotDrownTheReader) {
  std::string names = "#";
  for (int k = 0; k < 300; ++k) names += " c" + std::to_string(k);
  const std::string hint = read(names + "\n", {"max(nothing_of_it)"}).lacking.at("nothing_of_it");
  EXPECT_LT(hint.size(), 300u);
  EXPECT_NE(hint.find("c39 and 260 more"), std::string::npos);
}

TEST_F(HistoryFile, ACellThatIsNoNumberIsNone) {
  const auto numbers = read("# time a b\n0 1 2\n1 x\n", {"max(a)", "max(b)", "max(time)"});
  EXPECT_TRUE(std::isnan(numbers.values.at("max_a")));
  EXPECT_TRUE(std::isnan(numbers.values.at("max_b")));
  EXPECT_EQ(numbers.values.at("max_time"), 1);
}

TEST_F(HistoryFile, IsAFileErrorWhereThereIsNone) {
  EXPECT_THROW(read_history_numbers(folder / "none.txt", {value("last(time)")}), FileError);
  EXPECT_TRUE(read_history_numbers(folder / "none.txt", {}).values.empty());  // nothing is wanted of it
}

}  // namespace
}  // namespace tether
