// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as the overrides of a deck, one on each line.
#include <cstdint>
#include <string_view>

#include "base/text.hpp"
#include "deck/reader.hpp"
#include "fuzz/properties.hpp"

namespace {

constexpr std::string_view deck_text =
    "$in\nnx=11,ny=21,xleft=0.,xright=1.,ybot=0.,ytop=2.,tmax=1.,tstep=.1,iout(13)=1,tiout(13)=.1\n$\n"
    "$reg nreg=2,nprg=4,4 /\n";

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto overrides = tether::split_lines({reinterpret_cast<const char*>(data), size});
  tether::Diagnostics diagnostics;
  const auto deck = tether::read_deck(deck_text, "a.in", overrides, diagnostics);
  tether::Diagnostics of_deck, of_overrides;
  for (const auto& diagnostic : diagnostics.all()) {
    (diagnostic.place.file == tether::override_file ? of_overrides : of_deck).add(diagnostic);
  }
  tether::fuzz::expect_places_inside(of_deck, deck.lines());
  tether::fuzz::expect_places_inside(of_overrides, overrides);
  if (!diagnostics.has_errors()) tether::fuzz::expect_survives(deck);
  return 0;
}
