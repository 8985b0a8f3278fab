// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/table.hpp"

#include <gtest/gtest.h>
#include <netcdf.h>

#include <cmath>
#include <limits>

#include "base/diagnostics.hpp"
#include "unit/temporary_folder.hpp"

namespace tether {
namespace {

using Numbers = std::vector<double>;
using Texts = std::vector<std::string>;
constexpr double missing = std::numeric_limits<double>::quiet_NaN();

StudyTable small() {
  return {"run",
          {{"run", "number", "1", Numbers{1, 2, 3}},
           {"reg.yvi(3:4,1)", "value", "", Numbers{0.1, missing, 1e-300}},
           {"message", "why", "", Texts{"", "a, \"b\"", "line\nend"}}}};
}

TEST(CsvText, QuotesWhatNeedsIt) {
  EXPECT_EQ(csv_text(small()),
            "run,\"reg.yvi(3:4,1)\",message\n"
            "1,0.1,\n"
            "2,,\"a, \"\"b\"\"\"\n"
            "3,1e-300,\"line\nend\"\n");
}

TEST(CsvText, NumbersReadBackToTheSame) {
  const double third = 1.0 / 3;
  const StudyTable table{"run", {{"x", "", "", Numbers{third, std::nextafter(1.0, 2), 51}}}};
  EXPECT_EQ(csv_text(table), "x\n0.3333333333333333\n1.0000000000000002\n51\n");
}

TEST(CsvText, ATableWithoutRowsIsItsNames) {
  EXPECT_EQ(csv_text({"run", {{"x", "", "", Numbers{}}, {"y", "", "", Texts{}}}}), "x,y\n");
}

TEST(AlignedText, NumbersAtTheRightTextsAtTheLeft) {
  const StudyTable table{"run",
                         {{"n", "", "", Numbers{1, missing}},
                          {"word", "", "", Texts{"a", "long one"}},
                          {"x", "", "", Numbers{0.123456789, 2}}}};
  EXPECT_EQ(aligned_text(table, {"n", "word", "x"}),
            "n  word            x\n"
            "1  a         0.12346\n"
            "-  long one        2\n");
}

class TableFile : public test::TemporaryFolder {};

TEST_F(TableFile, HoldsNumbersAndTexts) {
  const auto path = folder / "table.nc";
  write_netcdf(path, small(), {"title", "tether sweep", "deck", "sum", Units::none});
  EXPECT_FALSE(std::filesystem::exists(folder / "table.nc.new"));
  int file = 0, variable = 0;
  ASSERT_EQ(nc_open(path.c_str(), NC_NOWRITE, &file), NC_NOERR);
  ASSERT_EQ(nc_inq_varid(file, "reg.yvi(3:4,1)", &variable), NC_NOERR);
  Numbers values(3);
  ASSERT_EQ(nc_get_var_double(file, variable, values.data()), NC_NOERR);
  EXPECT_EQ(values[0], 0.1);
  EXPECT_TRUE(std::isnan(values[1]));
  EXPECT_EQ(values[2], 1e-300);
  ASSERT_EQ(nc_inq_varid(file, "message", &variable), NC_NOERR);
  std::string texts(24, ' ');
  ASSERT_EQ(nc_get_var_text(file, variable, texts.data()), NC_NOERR);
  EXPECT_EQ(texts, std::string("\0\0\0\0\0\0\0\0a, \"b\"\0\0line\nend", 24));
  std::size_t length = 0;
  EXPECT_EQ(nc_inq_attlen(file, NC_GLOBAL, "git_hash", &length), NC_NOERR);
  EXPECT_EQ(nc_close(file), NC_NOERR);
}

TEST_F(TableFile, MayHaveNoRows) {
  write_netcdf(folder / "t.nc", {"run", {{"x", "", "", Numbers{}}, {"y", "", "", Texts{}}}}, {});
  EXPECT_TRUE(std::filesystem::exists(folder / "t.nc"));
}

TEST_F(TableFile, IsAFileErrorWhereThereIsNoFolder) {
  EXPECT_THROW(write_netcdf(folder / "no" / "t.nc", small(), {}), FileError);
}

}  // namespace
}  // namespace tether
