// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a deck.
#include <cstdint>
#include <string_view>

#include "deck/reader.hpp"
#include "fuzz/properties.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  tether::Diagnostics diagnostics;
  const auto deck = tether::read_deck(text, "a.in", {}, diagnostics);
  tether::fuzz::expect_places_inside(diagnostics, deck.lines());
  if (!diagnostics.has_errors()) tether::fuzz::expect_survives(deck);
  return 0;
}
