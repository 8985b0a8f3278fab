// SPDX-License-Identifier: GPL-3.0-or-later
// What tether reads from each deck of a list (on standard input, a path a line), in the form of oracle.f90:
//   DECK <path>
//   E <line>:<column>: <message>     an error
//   W <line>:<column>: <message>     a warning
//   V <group> <name>[(<i>[,<j>])] I <decimal> | R <16 hexadecimal digits> | L <T|F> | S [<text>]
#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <string>

#include "base/file.hpp"
#include "deck/elements.hpp"
#include "deck/reader.hpp"

namespace tether {
namespace {

struct Spelling {
  std::string operator()(long long value) const { return fmt::format("I {}", value); }
  std::string operator()(double value) const { return fmt::format("R {:016X}", std::bit_cast<std::uint64_t>(value)); }
  std::string operator()(bool value) const { return value ? "L T" : "L F"; }
  /// Without blanks at its end, which a Fortran text cannot tell from its filling.
  std::string operator()(const std::string& value) const {
    return fmt::format("S [{}]", value.substr(0, value.find_last_not_of(' ') + 1));
  }
};

void show_remarks(const Diagnostics& diagnostics) {
  for (const auto& remark : diagnostics.all()) {
    fmt::print("{} {}:{}: {}\n", remark.severity == Severity::error ? 'E' : 'W', remark.place.line, remark.place.column,
               remark.message);
  }
}

void show_values(const Deck& deck) {
  for (const auto& variable : variables()) {
    for (const auto& at : deck.given_elements(AnyVariable(variable))) {
      const auto value = deck.value(AnyVariable(variable), at[0], at[1]);
      fmt::print("V {} {} {}\n", variable.group, element_name(variable, at), std::visit(Spelling{}, value.data));
    }
  }
}

void show_deck(const std::string& path) {
  Diagnostics diagnostics;
  const Deck deck = read_deck(read_file(path), path, {}, diagnostics);
  fmt::print("DECK {}\n", path);
  show_remarks(diagnostics);
  show_values(deck);
}

}  // namespace
}  // namespace tether

int main() {
  for (std::string path; std::getline(std::cin, path);) tether::show_deck(path);
  return std::fflush(stdout) == 0 ? 0 : 1;
}
