// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/text.hpp"

#include <gtest/gtest.h>

namespace tether {
namespace {

using Lines = std::vector<std::string>;

TEST(SplitLines, EndsAtLineFeedCarriageReturnOrBoth) {
  const Lines three{"a", "b", "c"};
  EXPECT_EQ(split_lines("a\nb\nc"), three);
  EXPECT_EQ(split_lines("a\rb\rc"), three);
  EXPECT_EQ(split_lines("a\r\nb\r\nc"), three);
  EXPECT_EQ(split_lines("a\rb\nc\r\n"), three);
}

TEST(SplitLines, KeepsEmptyLinesButNoLastOne) {
  EXPECT_EQ(split_lines(""), Lines{});
  EXPECT_EQ(split_lines("\n"), Lines{""});
  EXPECT_EQ(split_lines("\r\n"), Lines{""});
  EXPECT_EQ(split_lines("a\n"), Lines{"a"});
  EXPECT_EQ(split_lines("a\n\n"), (Lines{"a", ""}));
  EXPECT_EQ(split_lines("\na"), (Lines{"", "a"}));
  EXPECT_EQ(split_lines("a\r\rb"), (Lines{"a", "", "b"}));
  EXPECT_EQ(split_lines("a\n\rb"), (Lines{"a", "", "b"}));  // LF CR is no pair
  EXPECT_EQ(split_lines("a\r"), Lines{"a"});
}

TEST(SplitLines, KeepsBlanksAndZeroBytes) {
  EXPECT_EQ(split_lines(" a\t\n"), Lines{" a\t"});
  EXPECT_EQ(split_lines(std::string("a\0b\nc", 5)), (Lines{std::string("a\0b", 3), "c"}));
}

TEST(Trim, TakesBlanksTabsAndLineEndsOffBothSides) {
  EXPECT_EQ(trim(" \t a b \r\n"), "a b");
  EXPECT_EQ(trim(""), "");
  EXPECT_EQ(trim(" \r\n\t"), "");
  EXPECT_EQ(trim("x"), "x");
}

TEST(Lower, ChangesAsciiLettersOnly) {
  EXPECT_EQ(lower("TStep(1,2)_AZ[@"), "tstep(1,2)_az[@");
  EXPECT_EQ(lower("\xc3\x84"), "\xc3\x84");  // a letter of two bytes stays
}

TEST(EditDistance, CountsInsertionsDeletionsAndReplacements) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("tmax", "tmax"), 0u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("abc", ""), 3u);
  EXPECT_EQ(edit_distance("tmax", "tmx"), 1u);
  EXPECT_EQ(edit_distance("tmax", "tmaxx"), 1u);
  EXPECT_EQ(edit_distance("tmax", "tmin"), 2u);
  EXPECT_EQ(edit_distance("tmax", "tamx"), 2u);  // letters that changed places
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(edit_distance("sitting", "kitten"), 3u);
}

TEST(NearestName, IsTheFirstOfTheNearest) {
  EXPECT_EQ(nearest_name("tmx", {"tplt", "tmax", "tmix"}), "tmax");
  EXPECT_EQ(nearest_name("dtmax", {"tmax", "dtmax"}), "dtmax");
  EXPECT_EQ(nearest_name("ipart", {"iprint", "ipath"}), "ipath");
}

TEST(NearestName, IsEmptyBeyondTheMost) {
  EXPECT_EQ(nearest_name("gravity", {"gravc"}), "");  // 3 changes
  EXPECT_EQ(nearest_name("gravity", {"gravc"}, 3), "gravc");
  EXPECT_EQ(nearest_name("tmx", {"tmax"}, 0), "");
  EXPECT_EQ(nearest_name("tmax", {}), "");
}

TEST(ShortText, KeepsTheEndsOfWhatIsLong) {
  EXPECT_EQ(shortened("abcdefgh", 8), "abcdefgh");
  EXPECT_EQ(shortened("abcdefghi", 8), "abc...hi");
  EXPECT_EQ(with_short_words("a abcdefghi\n  b abcdefghij", 8), "a abc...hi\n  b abc...ij");
  EXPECT_EQ(with_short_words(std::string(100000, 'a')).size(), 300U);
  EXPECT_EQ(with_short_words(""), "");
}

TEST(NoText, TextsAreNone) {
  for (const char* text : {"a", "$in\n nx=3 $\n", "\xef\xbb\xbf$in", "\xc3\xa4\xc3\xb6\xc3\xbc", "\t\r\n x"}) {
    EXPECT_EQ(no_text(text).message, "") << text;
  }
  EXPECT_EQ(no_text(std::string("$in nx=3\0 $ and some more of a deck", 35)).message, "");  // damaged in one place
  EXPECT_EQ(no_text("").message, "the file is empty");
  EXPECT_EQ(no_text(std::string("$\0i\0n\0\n\0", 8)).message, "this is a text in UTF-16, no plain text");
  EXPECT_EQ(no_text(std::string("\0$\0i\0n\0\n", 8)).message, "this is a text in UTF-16, no plain text");
  EXPECT_EQ(no_text(std::string("CDF\2", 4)).message, "this is a NetCDF file, no plain text");
  EXPECT_EQ(no_text(std::string(3000, '\1')).message, "this is a binary file, no plain text");
}

TEST(Sha256, OfThePublishedVectors) {  // FIPS 180-2, appendix B
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, CountsZeroBytes) { EXPECT_NE(sha256(std::string("a\0b", 3)), sha256("a")); }

}  // namespace
}  // namespace tether
