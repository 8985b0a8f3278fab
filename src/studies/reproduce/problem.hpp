// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "studies/assignment.hpp"
#include "studies/reproduce/files.hpp"

namespace tether::published {

// The published problems of the thesis as a table: a deck each, how either method runs it, and what of the finished run
// stands next to what is printed.

/// Reads one number off a finished run and nothing else; not a number where the run does not show it. Throws FileError
/// where the run did not write what is read.
using Readout = std::function<double(const RunFiles&)>;

/// The number, and not a number where there is no readout, or the run did not write what it reads.
double number_or_none(const Readout& readout, const RunFiles& run);

/// A number of the thesis, where it stands, and its band: how far off a value may be that agrees with it.
struct Printed {
  double value = 0;
  std::string place;  ///< "Table 3"
  double band = 0;    ///< in the number's own unit
};

/// How near a method's value must come to an exact one: what the method is known to reach, so that changes show.
struct Tolerance {
  double size = 0;
  bool relative = true;  ///< a part of what it is compared with; else in the quantity's own unit
};

constexpr Tolerance within_part(double part) { return {part, true}; }
constexpr Tolerance within(double size) { return {size, false}; }

/// Methods whose values are judged by the printed ones. The others' difference is reported: what one run of the thesis
/// printed with more digits than its theory or ours bears out is no measure.
enum class Judged { none, thesis, robust, both };

/// What a number of the thesis' theory is compared with: the exact value of the deck that ran, which says whether the
/// deck poses the thesis' problem; the runs' values, where the theory leaves out what the deck has; or nothing.
enum class TheoryFor { exact, runs, nothing };

/// A row of the table.
struct PublishedQuantity {
  std::string name = {};  ///< with its unit, where it has one
  Readout reading = {};
  bool of_deck = false;                 ///< the reading needs the deck alone: a run that came to no end shows it, too
  std::vector<Printed> published = {};  ///< several where the thesis contradicts itself; none of what it only draws
  Judged by_published = Judged::none;   ///< within the bands of the printed values
  std::optional<Printed> theory = {};   ///< what the thesis quotes of its theory, or its formula gives
  TheoryFor theory_for = TheoryFor::exact;  ///< judged within the band of the theory; of runs within the tolerances
  std::optional<Tolerance> thesis_by_theory = {}, robust_by_theory = {};
  Readout exact = {};                      ///< of the deck that ran; empty: none is known
  std::optional<Tolerance> thesis = {};    ///< of the thesis' method to the exact value; without it that is reported
  std::optional<Tolerance> robust = {};    ///< of the robust method
  std::optional<double> upper_bound = {};  ///< the thesis says "less than": judged by `by_published`
};

/// How a method runs a problem's deck.
struct MethodRuns {
  std::vector<std::string> overrides = {};  ///< group.name=value
  bool varied = false;                      ///< chaotic: several runs whose steps differ a little
};

struct Problem {
  std::string name = {};    ///< as the command takes it
  std::string source = {};  ///< what published it: "thesis"; empty: a deck of the user's own
  std::string place = {};   ///< where that has it
  std::string deck = {};    ///< path of the deck that is run
  bool by_points = true;    ///< material points, which have the methods; else a path of the deck's own
  MethodRuns thesis = {};   ///< the method of the source, which is the only one of a deck with a path of its own
  std::optional<MethodRuns> robust = MethodRuns{};  ///< none: has no meaning there
  std::string study = {};          ///< path of a bisection that is run on the deck, in place of a single run
  std::string compared_with = {};  ///< path of a deck that the same method runs as well, for what compares two runs
  std::vector<PublishedQuantity> quantities = {};
};

/// A printed text taken apart; where there are mistakes, the rest means nothing.
struct ReadPrinted {
  std::vector<Printed> values;
  std::optional<double> upper_bound;
  std::vector<Mistake> mistakes;
};

/// Numbers as a deck notes what a source prints: "0.0071 (Table 3)", whose band is half a unit of its last digit;
/// "6 +- 3 % (Box 10)" or "0 +- 0.5 (7.5.2)" with a band of its own; "= 0.05 (Box 2)" for what states the problem and
/// is exact; "19.8 (Table 1) or 18.44 (Box 7)" where the source contradicts itself; "< 0.005 (4.1)" for an upper bound,
/// which stands alone.
ReadPrinted read_printed(const std::string& text);

/// A tolerance taken apart: "2 %" of what is compared with, or "0.015" in the quantity's own unit.
struct ReadTolerance {
  Tolerance tolerance;
  std::vector<Mistake> mistakes;
};
ReadTolerance read_tolerance(const std::string& text);

}  // namespace tether::published
