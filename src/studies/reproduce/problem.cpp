// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/problem.hpp"

#include <cmath>
#include <regex>

#include "base/numbers.hpp"
#include "base/text.hpp"

namespace tether::published {

double number_or_none(const Readout& readout, const RunFiles& run) {
  if (!readout) return std::numeric_limits<double>::quiet_NaN();
  try {
    return readout(run);
  } catch (const FileError&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}
namespace {

/// One number: how it is meant, its digits, its band, its place, and whether another follows.
const std::regex number_form(
    R"(\s*([<=]?)\s*([-+.0-9eEdD]+)\s*(?:\+-\s*([-+.0-9eEdD]+)\s*(%?)\s*)?(?:\(([^()]*)\))?\s*(or\s+|$))");
const std::regex tolerance_form(R"(\s*([-+.0-9eEdD]+)\s*(%?)\s*)");

/// What states a problem is exact: it agrees to this part of itself.
constexpr double stated_part = 1e-6;

const char* const form =
    "Write it as '0.0071 (Table 3)', '6 +- 3 % (Box 10)', '= 0.05 (Box 2)', '19.8 (Table 1) or 18.44 (Box 7)', "
    "'< 1 (6.2)'.";

/// Half a unit of the last digit.
double half_digit(const std::string& digits) {
  const auto exponent = digits.find_first_of("eEdD");
  const std::string mantissa = digits.substr(0, exponent);
  const auto point = mantissa.find('.');
  const double decimals = point == std::string::npos ? 0 : static_cast<double>(mantissa.size() - point - 1);
  const double power = exponent == std::string::npos ? 0 : parse_real(digits.substr(exponent + 1)).value_or(0);
  return 0.5 * std::pow(10.0, power - decimals);
}

Mistake wrong_number(std::size_t at) { return {static_cast<int>(at) + 1, "this is no printed number", form}; }

/// That of "+- SIZE", of "= VALUE", else of the digits; nothing where the size is no number above 0.
std::optional<double> band_of(const std::smatch& number, double value) {
  if (number[1] == "=") return stated_part * std::abs(value);
  if (!number[3].matched) return half_digit(number[2]);
  const auto size = parse_real(number[3].str());
  if (!size || !(*size > 0)) return std::nullopt;
  return number[4].length() > 0 ? *size / 100 * std::abs(value) : *size;
}

}  // namespace

ReadPrinted read_printed(const std::string& text) {
  ReadPrinted read;
  for (std::size_t at = 0;;) {
    std::smatch found;
    const auto begin = text.begin() + static_cast<std::ptrdiff_t>(at);
    const bool is_number =
        std::regex_search(begin, text.end(), found, number_form, std::regex_constants::match_continuous);
    const auto value = is_number ? parse_real(found[2].str()) : std::nullopt;
    if (!value) return {{}, {}, {wrong_number(at)}};
    const auto band = band_of(found, *value);
    if (!band) return {{}, {}, {{static_cast<int>(at) + 1, "a band is a number above 0", form}}};
    const bool is_bound = found[1] == "<", is_last = found[6].length() == 0;
    if (is_bound && (at > 0 || !is_last)) return {{}, {}, {{1, "an upper bound stands alone", form}}};
    if (is_bound)
      read.upper_bound = *value;
    else
      read.values.push_back({*value, found[5], *band});
    if (is_last) return read;
    at += static_cast<std::size_t>(found.length());
  }
}

ReadTolerance read_tolerance(const std::string& text) {
  std::smatch found;
  const auto size = std::regex_match(text, found, tolerance_form) ? parse_real(found[1].str()) : std::nullopt;
  if (!size || !(*size > 0))
    return {{}, {{1, "this is no tolerance", "Write '2 %', or '0.015' in the quantity's unit."}}};
  if (found[2].length() > 0) return {within_part(*size / 100), {}};
  return {within(*size), {}};
}

}  // namespace tether::published
