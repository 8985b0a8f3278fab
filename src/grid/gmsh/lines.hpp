// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.hpp"

namespace tether::gmsh {

/// A line of a section, cut into words at blanks, read from left to right.
class Words {
 public:
  Words(const std::string& text, int line, Remarks& remarks) : text_(text), line_(line), remarks_(remarks) {}

  int line() const { return line_; }
  bool at_end();
  /// The next whole number from `low` to `high`; what stands there instead is reported, `what` says what it should be.
  std::optional<long long> whole(const char* what, long long low, long long high);
  /// The next finite number, its size at most 1e100, so that products of three are numbers, too.
  std::optional<double> real(const char* what);
  /// Returns what stands between the first and the last quote of the rest.
  std::optional<std::string> quoted(const char* what);
  /// Returns whether nothing is left, and reports what is left.
  bool done(const char* should_be);
  /// Reports the word that was read last, or an earlier one that is to blame, whose place() was kept.
  void error(std::string message, std::string hint = {});
  std::size_t place() const { return word_; }
  void blame(std::size_t place) { word_ = place; }

 private:
  std::string_view next();

  const std::string& text_;
  int line_;
  Remarks& remarks_;
  std::size_t at_ = 0, word_ = 0;  // after the word read last, and its first byte
};

/// The lines between $Name and $EndName.
struct Section {
  std::size_t begin = 0, end = 0;  ///< first line and the one after the last, from 0
  int line = 0;                    ///< of its $Name, from 1
};

/// The sections that a file has, by name without '$'; later ones of one name are reported as mistakes, except
/// $Comments. What stands outside of them, and sections without an end, are reported.
std::map<std::string, Section> sections_of(const std::vector<std::string>& lines, Remarks& remarks);

/// Lines of a section one by one, without the empty ones.
class Reader {
 public:
  Reader(const std::vector<std::string>& lines, const Section& section, Remarks& remarks)
      : lines_(lines), section_(section), remarks_(remarks), at_(section.begin) {}

  /// The next line, or nothing at the section's end.
  std::optional<Words> next();
  /// The next line, whose lack is reported as a lack of `what`.
  std::optional<Words> next(const std::string& what);
  /// Lines that are left, so many things can follow at most.
  long long left() const { return static_cast<long long>(section_.end - at_); }
  /// Reports, at the header's line, a count that the lines left do not bear out; false then.
  bool bears_out(Words& header, long long count, const char* what);
  /// Reports lines that are left.
  void expect_end(const char* counted);

 private:
  const std::vector<std::string>& lines_;
  Section section_;
  Remarks& remarks_;
  std::size_t at_;
};

}  // namespace tether::gmsh
