// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/reading.hpp"

#include <memory>

#include "studies/reproduce/read_formula.hpp"

namespace tether::published {

ReadReading read_reading(const std::string& text) {
  ReadReading read;
  const auto formula = read_formula(text, 0, read.mistakes);
  if (!read.mistakes.empty()) return read;
  read.reading = [formula](const RunFiles& run) { return formula->of_run(run); };
  read.of_deck = formula->of_deck();
  return read;
}

}  // namespace tether::published
