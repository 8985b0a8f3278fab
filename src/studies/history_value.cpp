// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/history_value.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "base/file.hpp"
#include "base/numbers.hpp"
#include "base/text.hpp"

namespace tether {
namespace {

/// Changes of a letter that still make a name of another.
constexpr std::size_t near_enough = 3;

/// More would drown the reader.
constexpr std::size_t most_shown = 40;

}  // namespace

std::string meant(const std::string& name, const std::vector<std::string>& known) {
  const auto near = nearest_name(name, known, near_enough);
  if (!near.empty()) return fmt::format("Did you mean '{}'?", near);
  const auto shown = std::min(known.size(), most_shown);
  const auto end = known.begin() + static_cast<std::ptrdiff_t>(shown);
  const std::string rest = shown < known.size() ? fmt::format(" and {} more", known.size() - shown) : "";
  return fmt::format("There are {}{}.", fmt::join(known.begin(), end, ", "), rest);
}

namespace {

using Numbers = std::vector<double>;
using Names = std::vector<std::string>;

/// A function of a column: which record it takes, and what of it.
struct Function {
  const char *name, *meaning;
  std::size_t (*record)(const Numbers& column);
  bool gives_time;
};

std::size_t first_of(const Numbers&) { return 0; }
std::size_t last_of(const Numbers& column) { return column.size() - 1; }
std::size_t largest_of(const Numbers& column) {
  return static_cast<std::size_t>(std::max_element(column.begin(), column.end()) - column.begin());
}
std::size_t least_of(const Numbers& column) {
  return static_cast<std::size_t>(std::min_element(column.begin(), column.end()) - column.begin());
}

constexpr std::array functions{
    Function{"first", "first record of", first_of, false},
    Function{"last", "last record of", last_of, false},
    Function{"max", "largest record of", largest_of, false},
    Function{"min", "least record of", least_of, false},
    Function{"time_of_max", "time of the first largest record of", largest_of, true},
    Function{"time_of_min", "time of the first least record of", least_of, true},
};

const Function* find_function(const std::string& name) {
  const auto named = [&](const Function& function) { return name == function.name; };
  const auto found = std::find_if(functions.begin(), functions.end(), named);
  return found == functions.end() ? nullptr : &*found;
}

Names function_names() {
  Names names;
  for (const Function& function : functions) names.emplace_back(function.name);
  return names;
}

/// As history.txt names its columns, and nothing that a table could not bear.
bool is_column_name(const std::string& name) {
  const auto good = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
  return !name.empty() && std::all_of(name.begin(), name.end(), good);
}

/// Word k of a line whose words stand a blank apart; empty where there are fewer.
std::string_view word_of(std::string_view line, std::size_t k) {
  std::size_t at = 0;
  for (; k > 0 && at < line.size(); --k) at = std::min(line.find(' ', at), line.size() - 1) + 1;
  return line.substr(at, line.find(' ', at) - at);
}

/// The lines of a history.txt: the names after the '#' of the first, and the numbers of the others.
class HistoryLines {
 public:
  explicit HistoryLines(const std::filesystem::path& path) : lines_(split_lines(read_file(path))) {
    const std::string first = lines_.empty() ? "" : lines_.front();
    for (std::size_t k = 1; !word_of(first, k).empty(); ++k) names_.emplace_back(word_of(first, k));
  }
  const Names& names() const { return names_; }
  bool has(const std::string& name) const { return place_of(name) < names_.size(); }
  Numbers column(const std::string& name) const {
    const std::size_t place = place_of(name);
    Numbers numbers;
    for (std::size_t k = 1; k < lines_.size(); ++k) {
      const auto number = parse_real(word_of(lines_[k], place));
      numbers.push_back(number.value_or(std::numeric_limits<double>::quiet_NaN()));
    }
    return numbers;
  }

 private:
  std::size_t place_of(const std::string& name) const {
    return static_cast<std::size_t>(std::find(names_.begin(), names_.end(), name) - names_.begin());
  }
  Names lines_, names_;
};

}  // namespace

std::string HistoryValue::meaning() const {
  return fmt::format("{} {} in history.txt", find_function(function)->meaning, column);
}

bool is_history_value(const std::string& text) { return text.find_first_of("()") != std::string::npos; }

ReadHistoryValue read_history_value(const std::string& text) {
  const auto refuse = [](std::size_t at, const std::string& message, const std::string& hint) {
    return ReadHistoryValue{{}, {{static_cast<int>(at) + 1, message, hint}}};
  };
  const auto open = text.find('('), close = text.find(')');
  const std::string form = "Write it as last(body_vx_1).";
  if (open == std::string::npos || close < open) return refuse(close, "nothing opens this bracket", form);
  const std::string function(trim(text.substr(0, open)));
  if (find_function(function) == nullptr)
    return refuse(0, fmt::format("there is no function '{}' of a column of history.txt", function),
                  meant(function, function_names()));
  if (close == std::string::npos) return refuse(open, "this bracket is not closed", form);
  if (!trim(text.substr(close + 1)).empty())
    return refuse(close + 1, "something stands after the bracket", "A quantity is one value. " + form);
  const std::string inside = text.substr(open + 1, close - open - 1), column(trim(inside));
  const std::size_t at = open + 1 + std::min(inside.find_first_not_of(" \t"), inside.size());
  if (!is_column_name(column))
    return refuse(at, fmt::format("'{}' is no name of a column of history.txt", column),
                  "They are of lower-case letters, digits and '_', as its first line has them.");
  return {{function, column, static_cast<int>(at) + 1}, {}};
}

double number_of(const HistoryValue& value, const Numbers& times, const Numbers& column) {
  const auto no_number = [](double number) { return std::isnan(number); };
  const bool none = column.empty() || std::any_of(column.begin(), column.end(), no_number);
  if (none) return std::numeric_limits<double>::quiet_NaN();
  const Function& function = *find_function(value.function);
  const std::size_t record = function.record(column);
  return function.gives_time ? times[record] : column[record];
}

HistoryNumbers read_history_numbers(const std::filesystem::path& path, const std::vector<HistoryValue>& values) {
  HistoryNumbers result;
  if (values.empty()) return result;
  const HistoryLines lines(path);
  const Numbers times = lines.column("time");
  for (const HistoryValue& value : values) {
    if (lines.has(value.column))
      result.values[value.name()] = number_of(value, times, lines.column(value.column));
    else
      result.lacking[value.column] = meant(value.column, lines.names());
  }
  return result;
}

}  // namespace tether
