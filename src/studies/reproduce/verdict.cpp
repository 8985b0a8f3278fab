// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/verdict.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/diagnostics.hpp"
#include "base/numbers.hpp"
#include "studies/reproduce/point_readings.hpp"

namespace tether::published {
namespace {

/// Rounding of a band's own arithmetic.
constexpr double band_slip = 1e-9;

/// A distance from a number: in per cent of it, or, where that has no meaning, in its own unit.
std::string distance_text(double size, double of) {
  if (of == 0) return fmt::format("{:.2g}", std::abs(size));
  const double percent = 100 * std::abs(size / of);
  return percent < 100 ? fmt::format("{:.2g} %", percent) : fmt::format("{:.0f} %", percent);
}

std::string signed_text(double size, double of) {
  return fmt::format("{}{}", size < 0 ? "-" : "+", distance_text(size, of));
}

/// The printed value that is nearest.
const Printed& nearest(const std::vector<Printed>& published, double value) {
  const auto nearer = [value](const Printed& a, const Printed& b) {
    return std::abs(a.value - value) < std::abs(b.value - value);
  };
  return *std::min_element(published.begin(), published.end(), nearer);
}

/// A tolerance as the band about an exact value.
Printed exact_target(double exact, const std::optional<Tolerance>& tolerance) {
  const double size = tolerance ? tolerance->size : 0;
  return {exact, "exact", tolerance && tolerance->relative && exact != 0 ? size * std::abs(exact) : size};
}

/// One after the other; the worst stands for both.
Verdict together(const Verdict& a, const Verdict& b) {
  if (a.text.empty() || b.text.empty()) return a.text.empty() ? b : a;
  if (a.standing == Standing::reported && b.standing != Standing::reported) return together(b, a);
  return {a.text + ", " + b.text, std::max(a.standing, b.standing)};
}

Verdict on_bound(double bound, double value, bool judged) {
  if (!judged) return {fmt::format("{}below {}", value < bound ? "" : "not ", bound), Standing::reported};
  if (value < bound) return {fmt::format("agrees, below {}", bound), Standing::agrees};
  return {fmt::format("differs, not below {}", bound), Standing::differs};
}

/// How either method is judged by a row.
struct MethodRule {
  bool by_published = false;
  std::optional<Tolerance> by_exact, by_theory;
};

Verdict on_method(const PublishedQuantity& quantity, const MethodResult& method, const MethodRule& rule) {
  if (method.runs == 0) return {};
  const Measured measured = measure(quantity, method);
  const double value = measured.median();
  const bool judged = rule.by_published || rule.by_exact || rule.by_theory;
  const Standing without_value = method.is_finished ? Standing::differs : Standing::undecided;
  if (std::isnan(value)) return {"no value: " + measured.failure, judged ? without_value : Standing::reported};
  Verdict verdict;
  if (quantity.upper_bound) verdict = on_bound(*quantity.upper_bound, value, rule.by_published);
  if (!quantity.published.empty()) {
    verdict = compare_with(measured, nearest(quantity.published, value), rule.by_published, true);
  }
  if (quantity.theory && quantity.theory_for == TheoryFor::runs) {
    Printed target = exact_target(quantity.theory->value, rule.by_theory);
    target.place = "theory";
    verdict = together(verdict, compare_with(measured, target, rule.by_theory.has_value(), false));
  }
  const double exact = exact_of(quantity, method);
  if (!std::isnan(exact)) {
    const Printed target = exact_target(exact, rule.by_exact);
    verdict = together(verdict, compare_with(measured, target, rule.by_exact.has_value(), false));
  }
  return verdict.text.empty() ? Verdict{"reported", Standing::reported} : verdict;
}

/// Why runs that ended well have no exact value although the row has one; empty where they have it, or none ended.
std::string why_not_exact(const PublishedQuantity& quantity, const MethodResult& method) {
  if (!quantity.exact || method.files.empty() || !std::isnan(exact_of(quantity, method))) return "";
  try {
    quantity.exact(method.files.front());
  } catch (const FileError& error) {
    return error.what();
  }
  return "the run does not show it";
}

Verdict on_missing(const PublishedQuantity& quantity, const MethodResult& thesis, const MethodResult& robust) {
  const std::string by_thesis = why_not_exact(quantity, thesis),
                    why = by_thesis.empty() ? why_not_exact(quantity, robust) : by_thesis;
  if (why.empty()) return {};
  const bool is_needed =
      quantity.thesis || quantity.robust || (quantity.theory && quantity.theory_for == TheoryFor::exact);
  const Standing without_exact = thesis.is_finished && robust.is_finished ? Standing::differs : Standing::undecided;
  return {"no exact value: " + why, is_needed ? without_exact : Standing::reported};
}

Verdict on_theory(const PublishedQuantity& quantity, double exact) {
  if (!quantity.theory || quantity.theory_for == TheoryFor::runs || std::isnan(exact)) return {};
  const Printed& theory = *quantity.theory;
  return compare_with({{theory.value}, 1, ""}, {exact, "exact", theory.band}, quantity.theory_for == TheoryFor::exact,
                      false);
}

}  // namespace

double Measured::median() const {
  if (values.empty() || 2 * values.size() <= runs) return no_number;
  auto sorted = values;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t middle = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
}

double Measured::spread() const {
  if (values.size() < 2) return no_number;
  double squares = 0;
  for (const double value : values) squares += (value - mean(values)) * (value - mean(values));
  return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

Measured measure(const PublishedQuantity& quantity, const MethodResult& result) {
  Measured measured{{}, result.runs, result.failure};
  for (const RunFiles& files : quantity.of_deck ? result.begun : result.files) {
    double value = no_number;
    try {
      value = quantity.reading(files);
    } catch (const FileError& error) {
      if (measured.failure.empty()) measured.failure = error.what();
    }
    if (!std::isnan(value)) measured.values.push_back(value);
  }
  if (measured.values.size() < measured.runs && measured.failure.empty()) measured.failure = "the run does not show it";
  return measured;
}

Verdict compare_with(const Measured& measured, const Printed& target, bool judged, bool one_of_many) {
  const double value = measured.median(), off = value - target.value;
  if (!judged) {
    const bool is_there = std::abs(off) <= target.band * (1 + band_slip);
    return {is_there ? fmt::format("as {}", target.place)
                     : fmt::format("{} off {}", signed_text(off, target.value), target.place),
            Standing::reported};
  }
  const double spread = measured.values.size() > 1 ? measured.spread() : 0;
  const double band = target.band + (one_of_many ? spread : 0);
  const std::string allowed = distance_text(band, target.value);
  if (std::abs(off) > band * (1 + band_slip)) {
    return {fmt::format("differs from {} by {} ({} allowed)", target.place, distance_text(off, target.value), allowed),
            Standing::differs};
  }
  if (spread > target.band * (1 + band_slip)) {
    return {fmt::format("undecided: runs spread by {}, {} allows {}", distance_text(spread, target.value), target.place,
                        distance_text(target.band, target.value)),
            Standing::undecided};
  }
  return {fmt::format("agrees with {} within {}", target.place, allowed), Standing::agrees};
}

double exact_of(const PublishedQuantity& quantity, const MethodResult& method) {
  if (!quantity.exact) return no_number;
  for (const RunFiles& files : method.files) {
    try {
      const double exact = quantity.exact(files);
      if (!std::isnan(exact)) return exact;
    } catch (const FileError&) {
      continue;  // a run that has no exact value: the next one
    }
  }
  return no_number;
}

Judgement judge(const PublishedQuantity& quantity, const MethodResult& thesis, const MethodResult& robust) {
  const auto is_judged = [&](Judged method) {
    return quantity.by_published == method || quantity.by_published == Judged::both;
  };
  Judgement judgement;
  judgement.thesis =
      on_method(quantity, thesis, {is_judged(Judged::thesis), quantity.thesis, quantity.thesis_by_theory});
  judgement.robust =
      on_method(quantity, robust, {is_judged(Judged::robust), quantity.robust, quantity.robust_by_theory});
  judgement.exact = exact_of(quantity, thesis);
  if (std::isnan(judgement.exact)) judgement.exact = exact_of(quantity, robust);
  judgement.theory = on_theory(quantity, judgement.exact);
  if (std::isnan(judgement.exact)) judgement.missing = on_missing(quantity, thesis, robust);
  return judgement;
}

Standing Judgement::standing() const {
  return std::max({thesis.standing, robust.standing, theory.standing, missing.standing});
}

std::string Judgement::text(const std::string& first) const {
  std::vector<std::string> said;
  if (!thesis.text.empty() && thesis.text == robust.text) {
    said.push_back("both: " + thesis.text);
  } else {
    if (!thesis.text.empty()) said.push_back(first + ": " + thesis.text);
    if (!robust.text.empty()) said.push_back("robust: " + robust.text);
  }
  if (!theory.text.empty()) said.push_back("theory: " + theory.text);
  if (!missing.text.empty()) said.push_back(missing.text);
  return fmt::format("{}", fmt::join(said, "; "));
}

}  // namespace tether::published
