// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <vector>

#include "base/text.hpp"
#include "studies/map/map.hpp"

namespace tether::map {
namespace {

/// What a verdict is in the picture; a capital letter where the square was run itself, and '.' becomes '+'.
struct Sign {
  std::string_view verdict;
  char sign;
};
constexpr std::array signs{Sign{"holds", '.'},
                           Sign{"grows", 'g'},
                           Sign{"falls short", 'f'},
                           Sign{word_of(Failure::diverges), 'd'},
                           Sign{word_of(Failure::loses_points), 'l'},
                           Sign{word_of(Failure::inverts), 'i'},
                           Sign{word_of(Failure::does_not_converge), 'c'},
                           Sign{word_of(Failure::contradicts_energy), 'e'},
                           Sign{"tells nothing", '?'}};

char sign_of(std::string_view verdict, bool own) {
  const auto* found =
      std::find_if(signs.begin(), signs.end(), [&](const Sign& each) { return each.verdict == verdict; });
  const char sign = found == signs.end() ? '?' : found->sign;
  if (!own) return sign;
  return sign == '.' ? '+' : sign == '?' ? '?' : static_cast<char>(sign - 'a' + 'A');
}

std::string text_of(const Cell& cell) {
  return std::holds_alternative<double>(cell) ? fmt::format("{:.6g}", std::get<double>(cell))
                                              : std::get<std::string>(cell);
}

/// The leading axes' values of a square: "in.nx = 9, in.tstep = 0.01".
std::string values_text(const Study& study, const Combination& at, std::optional<std::size_t> without = {}) {
  std::vector<std::string> texts;
  for (const std::size_t a : leading_axes(study)) {
    if (a != without)
      texts.push_back(fmt::format("{} = {}", study.axes[a].variable, text_of(study.axes[a].cells[at.values[a]])));
  }
  if (study.decks.size() > 1) texts.insert(texts.begin(), study.decks[at.deck].file);
  return texts.empty() ? "" : fmt::format("{}: ", fmt::join(texts, ", "));
}

std::string legend(const Outcome& outcome) {
  const std::set<std::string> seen(outcome.verdicts.begin(), outcome.verdicts.end());
  std::string text = "+ and capital letters are runs, the rest follows from them:";
  for (const Sign& sign : signs) {
    if (sign.sign != '?' && seen.contains(std::string(sign.verdict)))
      text += fmt::format(" {}{} {}", sign.sign, sign.sign == '.' ? "+" : std::string(1, sign_of(sign.verdict, true)),
                          sign.verdict);
  }
  const bool open = std::ranges::any_of(outcome.decided_by, [](const auto& by) { return !by; });
  return text + (open ? " ? not known" : "") + "\n";
}

/// A line a value of the second axis, the largest first, a sign a value of the first.
std::string picture(const Study& study, const Outcome& outcome, std::size_t deck) {
  const auto leading = leading_axes(study);
  const StudyAxis& across = study.axes[leading[0]];
  const std::size_t nx = across.cells.size();
  const StudyAxis* up = leading.size() > 1 ? &study.axes[leading[1]] : nullptr;
  const std::size_t ny = up ? up->cells.size() : 1;
  std::size_t width = 0;
  for (std::size_t j = 0; up && j < ny; ++j) width = std::max(width, text_of(up->cells[j]).size());
  std::string text = up ? up->variable + "\n" : "";
  for (std::size_t j = ny; j-- > 0;) {
    text += fmt::format("{:>{}} ", up ? text_of(up->cells[j]) : "", width);
    for (std::size_t i = 0; i < nx; ++i) {
      const std::size_t square = (deck * ny + j) * nx + i;
      const auto by = outcome.decided_by[square];
      text += by ? sign_of(outcome.verdicts[*by], outcome.runs[*by].variant.combination == square) : '?';
    }
    text += "\n";
  }
  return text + fmt::format("{:>{}} {} from {} to {}\n", "", width, across.variable, text_of(across.cells.front()),
                            text_of(across.cells.back()));
}

std::string pictures(const Study& study, const Outcome& outcome) {
  std::string text;
  for (std::size_t deck = 0; deck < study.decks.size(); ++deck) {
    if (study.decks.size() > 1) text += study.decks[deck].file + "\n";
    text += picture(study, outcome, deck) + "\n";
  }
  return text + legend(outcome);
}

/// ", 2.0 by theory, between them", or how far the middle is from it: ", 2.0 by theory (-1.3 %)".
std::string theory_text(double theory, double low, double high) {
  if (!std::isfinite(theory)) return "";
  if (theory == 0) return ", 0 by theory";
  const std::string text = fmt::format(", {:.5g} by theory", theory);
  if (theory >= std::min(low, high) && theory <= std::max(low, high)) return text + ", between them";
  return text + fmt::format(" ({:+.2g} %)", 100 * (0.5 * (low + high) / theory - 1));
}

/// Lines on which the verdict changes more than once: between them smaller parts may be.
bool is_ragged(const Border& border, const Map& map) {
  const auto all = combinations(map.study);
  std::set<std::string> seen;
  return std::ranges::any_of(border.crossings, [&](const Crossing& crossing) {
    return !seen.insert(values_text(map.study, all[crossing.square], border.axis)).second;
  });
}

std::string borders(const Map& map, const Outcome& outcome) {
  const Border border = border_of(map, outcome);
  if (!border.axis) return "";
  const auto all = combinations(map.study);
  const StudyAxis& along = map.study.axes[*border.axis];
  std::string text = fmt::format("\nthe border in {}, known to half a step: {:.2g} % of the axis\n", along.variable,
                                 50. / static_cast<double>(along.cells.size() - 1));
  for (const Crossing& crossing : border.crossings) {
    text += fmt::format("  {}holds {} {:.5g} to {:.5g}{}\n", values_text(map.study, all[crossing.square], border.axis),
                        crossing.holds_below ? "below" : "above", crossing.low, crossing.high,
                        theory_text(crossing.theory, crossing.low, crossing.high));
  }
  if (border.crossings.empty()) text += "  none was found\n";
  if (is_ragged(border, map) && map.study.coarse > 1)
    text += "  It is crossed more than once: smaller parts of it may not have been seen; coarse=1 runs all squares.\n";
  return text;
}

/// Says where a bisected value ends to hold. That all of its values hold, or none, is an answer, too.
std::string bisected_text(const Bisection& bisection, const Interval& interval, double theory) {
  if (bisection.found())
    return fmt::format("{:.5g} to {:.5g}{}", bisection.holds(), bisection.fails(),
                       theory_text(theory, bisection.holds(), bisection.fails()));
  const std::string verdict = bisection.verdict();
  if (verdict == "both ends hold") return fmt::format("above {:.5g}: both ends hold", interval.high);
  if (verdict == "both ends fail") return fmt::format("below {:.5g}: both ends fail", interval.low);
  return verdict;
}

std::string bisections(const Map& map, const Outcome& outcome) {
  const auto all = combinations(map.study);
  std::string text = fmt::format("the largest {} that holds\n", map.study.vary.variable);
  for (std::size_t k = 0; k < all.size(); ++k)
    text += fmt::format("  {}{}\n", values_text(map.study, all[k]),
                        bisected_text(outcome.bisections[k], map.study.interval, bisected_theory(outcome, k)));
  return text;
}

/// Counts the runs at all values as close together as the border is known.
double runs_of_all(const Study& study, std::size_t squares) {
  if (!study.bisects()) return static_cast<double>(squares);
  const auto& [low, high, tolerance] = study.interval;
  const double steps = (high - low) / (tolerance * std::max(std::abs(low), std::abs(high)));
  return static_cast<double>(squares) * (std::ceil(steps) + 1);
}

std::string cost(const Map& map, const Outcome& outcome) {
  const double all = runs_of_all(map.study, combinations(map.study).size());
  const auto made = static_cast<double>(outcome.runs.size());
  double seconds = 0;
  for (const FinishedRun& run : outcome.runs) seconds += run.record.cpu_seconds;
  std::map<std::string, int> counts;
  for (const auto& verdict : outcome.verdicts) ++counts[verdict];
  std::vector<std::string> each;
  for (const auto& [verdict, count] : counts) each.push_back(fmt::format("{} {}", count, verdict));
  return fmt::format("\n{} runs of {:.0f} ({:.3g} %) in {:.3g} s of a processor: {}\n", made, all, 100 * made / all,
                     seconds, fmt::join(each, ", "));
}

std::string telling_nothing(const Map& map, const Outcome& outcome) {
  std::string text;
  for (std::size_t k = 0; k < outcome.runs.size(); ++k) {
    const FinishedRun& run = outcome.runs[k];
    if (run.meets(map.study.criterion)) continue;
    text += fmt::format(
        "run {} tells nothing: {}\n", k + 1,
        run.failed() ? run.record.ending.message : "it ended well, and has no number for " + map.study.criterion.key);
  }
  return text;
}

}  // namespace

std::string report_text(const Map& map, const Outcome& outcome) {
  std::string text = outcome.finished ? "" : "NOT FINISHED: the same command continues it\n\n";
  text += map.study.bisects() ? bisections(map, outcome) : pictures(map.study, outcome) + borders(map, outcome);
  const bool has_theory = std::ranges::any_of(outcome.theory, [](double each) { return std::isfinite(each); });
  if (map.theory && !has_theory) text += "  No run shows what theory reads.\n";
  return text + cost(map, outcome) + telling_nothing(map, outcome);
}

}  // namespace tether::map
