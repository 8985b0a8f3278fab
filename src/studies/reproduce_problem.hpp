// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "studies/reproduce_files.hpp"

// The published problems of the thesis as a table: a deck each, how either method runs it, and what of the finished run
// stands beside what the thesis prints.
namespace tether::published {

/// Reads one number off a finished run and nothing else; not a number where the run does not show it. Throws FileError
/// where the run did not write what is read.
using Readout = std::function<double(const RunFiles&)>;

/// A number of the thesis and where it stands.
struct Printed {
  double value = 0;
  std::string place;  ///< "Table 3"
};

/// How near a method's value must come. Most were set about what the runs gave: they show that results change, and are
/// no judgement from outside.
struct Tolerance {
  double size = 0;
  bool relative = true;  ///< a part of what it is compared with; else in the quantity's own unit
};

constexpr Tolerance within_part(double part) { return {part, true}; }
constexpr Tolerance within(double size) { return {size, false}; }

/// A row of the table. The value of each method is compared with the exact one, where there is none with the nearest of
/// those that the thesis prints.
struct Quantity {
  std::string name = {};  ///< with its unit, where it has one
  Readout reading = {};
  std::vector<Printed> published = {};     ///< several where the thesis contradicts itself; none of what it only draws
  std::function<double()> exact = {};      ///< of the thesis' problem, whatever the deck says; empty: none is known
  std::optional<Tolerance> thesis = {};    ///< of the thesis' method; without it the value is reported, not judged
  std::optional<Tolerance> robust = {};    ///< of the robust method
  std::optional<double> upper_bound = {};  ///< the thesis says "less than": judged where a tolerance stands
};

/// How a method runs a problem's deck.
struct MethodRuns {
  std::vector<std::string> overrides = {};  ///< group.name=value
  bool varied = false;                      ///< chaotic: several runs whose steps differ a little
};

struct Problem {
  std::string name = {};   ///< as the command takes it
  std::string place = {};  ///< where the thesis has it
  std::string deck = {};   ///< decks/DECK.in
  MethodRuns thesis = {};
  std::optional<MethodRuns> robust =
      MethodRuns{};         ///< its overrides beside the method itself; none: has no meaning there
  std::string study = {};   ///< decks/studies/STUDY.in, a bisection that is run on the deck, in place of a single run
  std::string beside = {};  ///< decks/BESIDE.in, which the same method runs as well, for what compares two runs
  std::vector<Quantity> quantities = {};
};

}  // namespace tether::published
