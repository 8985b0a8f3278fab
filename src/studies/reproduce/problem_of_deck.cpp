// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/problem_of_deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <regex>
#include <set>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "deck/reader.hpp"
#include "read/path.hpp"
#include "read/values.hpp"
#include "studies/reproduce/problem.hpp"
#include "studies/reproduce/read_formula.hpp"
#include "studies/study_checks.hpp"

namespace tether::published {
namespace {

namespace fs = std::filesystem;

constexpr std::array judged_words{std::pair{"none", Judged::none}, std::pair{"thesis", Judged::thesis},
                                  std::pair{"robust", Judged::robust}, std::pair{"both", Judged::both}};
constexpr std::array theory_words{std::pair{"exact", TheoryFor::exact}, std::pair{"runs", TheoryFor::runs},
                                  std::pair{"nothing", TheoryFor::nothing}};

/// The enumerator of a word that the table of variables allows.
template <typename Words>
auto chosen(const Words& words, const std::string& word) {
  const auto found = std::find_if(words.begin(), words.end(), [&](const auto& pair) { return pair.first == word; });
  return found == words.end() ? words.front().second : found->second;
}

/// Returns whether points are the deck's path, which alone has two methods.
bool is_by_points(const Deck& deck) {
  Diagnostics of_the_run;
  return path_of(deck, of_the_run) == Path::mpm;
}

/// Takes a problem out of the deck that has it, or of the deck that this one is like; each mistake is noted at its
/// place in the deck that has it.
class ProblemReader {
 public:
  ProblemReader(const Deck& deck, Diagnostics& diagnostics)
      : deck_(deck), diagnostics_(diagnostics), remarks_(deck, diagnostics) {
    if (const auto like = other("published.like")) like_ = like;
  }

  Problem read() {
    Problem problem{.name = problem_name(deck_), .source = text("published.source"), .place = text("published.place")};
    problem.deck = deck_.file();
    std::optional<Deck> run = deck_;
    if (is_given("published.deck")) run = other("published.deck");
    if (!run) return problem;
    problem.deck = run->file();
    if (const auto reference = other("published.compared_with")) problem.compared_with = reference->file();
    if (const auto study = other("published.study")) problem.study = study->file();
    read_methods(problem, is_by_points(*run));
    for (const int k : rows()) problem.quantities.push_back(row(k));
    if (problem.quantities.empty())
      remarks_.error("published.quantity", 1, "the problem has no quantity", "quantity(1)='period', is(1)='period'");
    return problem;
  }

 private:
  /// The deck that gives an element: this one, else the one that it is like.
  const Deck& giver(TextVariable name, int k) const { return like_ && !deck_.given(name, k) ? *like_ : deck_; }
  bool is_given(TextVariable name, int k = 1) const { return giver(name, k).given(name, k); }
  std::string text(TextVariable name, int k = 1) const {
    return is_given(name, k) ? giver(name, k).text(name, k) : fallback(name);
  }
  static std::string fallback(TextVariable name) {
    const auto word = name.row().fallback;
    return word.size() > 2 ? std::string(word.substr(1, word.size() - 2)) : "";
  }
  std::vector<int> elements(TextVariable name) const {
    std::set<int> numbers;
    for (const auto& at : deck_.given_elements(name)) numbers.insert(at[0]);
    if (like_) {
      for (const auto& at : like_->given_elements(name)) numbers.insert(at[0]);
    }
    return {numbers.begin(), numbers.end()};
  }
  std::vector<int> rows() const {
    std::vector<int> all = elements("published.quantity");
    for (const int k : elements("published.is")) {
      if (std::find(all.begin(), all.end(), k) == all.end())
        remarks_.error("published.is", k, "this row has no name", fmt::format("quantity({})='period'", k));
    }
    return all;
  }

  /// The deck that a path names; nothing where there is none, or a mistake, which is noted.
  std::optional<Deck> other(TextVariable name) {
    const std::string path = text(name);
    if (path.empty()) return std::nullopt;
    if (const std::string mistake = path_mistake(path); !mistake.empty()) {
      remarks_.error(name, 1, "the path " + mistake, path_hint("../sod.in"));
      return std::nullopt;
    }
    const std::string file = path_beside(giver(name, 1), path).lexically_normal().string();
    try {
      Diagnostics of_its_own;  // reported where the deck is run
      return read_deck(read_file(file), file, {}, of_its_own);
    } catch (const FileError& error) {
      remarks_.error(name, 1, error.what(), "the path counts from the deck's folder");
      return std::nullopt;
    }
  }

  std::vector<std::string> sets(TextVariable name) const {
    std::vector<std::string> all;
    for (const int k : elements(name)) all.push_back(text(name, k));
    return all;
  }

  void read_methods(Problem& problem, bool by_points) {
    const Judged varied = chosen(judged_words, text("published.varied"));
    problem.by_points = by_points;
    problem.thesis = {sets("published.thesis_set"), varied == Judged::thesis || varied == Judged::both};
    problem.robust = MethodRuns{sets("published.robust_set"), varied == Judged::robust || varied == Judged::both};
    if (!by_points || text("published.methods") == "thesis") problem.robust.reset();
  }

  PublishedQuantity row(int k) {
    PublishedQuantity row{.name = text("published.quantity", k)};
    if (!is_given("published.is", k))
      remarks_.error("published.quantity", k, "this row reads nothing", fmt::format("is({})='period'", k));
    const ReadReading is = reading("published.is", k);
    row.reading = is.reading, row.of_deck = is.of_deck;
    row.exact = reading("published.exact", k).reading;
    const ReadPrinted printed = numbers("published.printed", k), theory = numbers("published.theory", k);
    row.published = printed.values, row.upper_bound = printed.upper_bound;
    if (!theory.values.empty()) row.theory = theory.values.front();
    row.by_published = chosen(judged_words, text("published.judged", k));
    row.theory_for = chosen(theory_words, text("published.theory_for", k));
    row.thesis = tolerance("published.thesis_within", k), row.robust = tolerance("published.robust_within", k);
    row.thesis_by_theory = tolerance("published.thesis_to_theory", k),
    row.robust_by_theory = tolerance("published.robust_to_theory", k);
    check(row, k);
    return row;
  }

  /// A reading with what earlier rows read in place of row(1), row(2) ...
  std::string with_rows(const std::string& reading, int k) const {
    static const std::regex row_form(R"(\brow\(\s*(\d{1,2})\s*\))");
    std::string whole;
    auto from = reading.begin();
    for (std::sregex_iterator at(reading.begin(), reading.end(), row_form), end; at != end; ++at) {
      const int earlier = std::stoi((*at)[1]);
      whole.append(from, (*at)[0].first);
      whole += earlier >= 1 && earlier < k ? "(" + with_rows(text("published.is", earlier), earlier) + ")"
                                           : std::string((*at)[0]);
      from = (*at)[0].second;
    }
    return whole.append(from, reading.end());
  }

  ReadReading reading(TextVariable name, int k) {
    if (!is_given(name, k)) return {};
    const std::string as_given = text(name, k), whole = with_rows(as_given, k);
    ReadReading read = read_reading(whole);
    if (whole != as_given) {  // the columns of mistakes are not those of the text
      for (Mistake& mistake : read.mistakes) mistake.column = 1;
    }
    note(name, k, read.mistakes);
    return read;
  }
  ReadPrinted numbers(TextVariable name, int k) {
    if (!is_given(name, k)) return {};
    ReadPrinted read = read_printed(text(name, k));
    note(name, k, read.mistakes);
    return read;
  }
  std::optional<Tolerance> tolerance(TextVariable name, int k) {
    if (!is_given(name, k)) return std::nullopt;
    const ReadTolerance read = read_tolerance(text(name, k));
    note(name, k, read.mistakes);
    return read.tolerance;
  }

  /// Checks that what a row judges by is there.
  void check(const PublishedQuantity& row, int k) {
    const bool is_printed = is_given("published.printed", k), has_theory = is_given("published.theory", k);
    if (row.by_published != Judged::none && !is_printed)
      remarks_.error("published.judged", k, "nothing is printed that this row could be judged by",
                     fmt::format("printed({})='0.5 (Table 3)'", k));
    if ((row.thesis || row.robust) && !is_given("published.exact", k))
      remarks_.error(row.thesis ? AnyVariable("published.thesis_within") : "published.robust_within", k,
                     "there is no exact value to be near to", fmt::format("exact({})='exact_period'", k));
    if ((row.thesis_by_theory || row.robust_by_theory) && (!has_theory || row.theory_for != TheoryFor::runs))
      remarks_.error(row.thesis_by_theory ? AnyVariable("published.thesis_to_theory") : "published.robust_to_theory", k,
                     "there is no theory for the runs to be near to",
                     fmt::format("theory({})='0.02 (5.11)', theory_for({})='runs'", k, k));
  }

  void note(TextVariable name, int k, const std::vector<Mistake>& mistakes) {
    if (mistakes.empty()) return;
    StudyRemarks(giver(name, k), diagnostics_).tell(name, k, mistakes);
  }

  const Deck& deck_;
  Diagnostics& diagnostics_;
  mutable StudyRemarks remarks_;
  std::optional<Deck> like_;
};

}  // namespace

Problem problem_of(const Deck& deck, Diagnostics& diagnostics) { return ProblemReader(deck, diagnostics).read(); }

std::string problem_name(const Deck& deck) {
  const std::string name = deck.text("published.name");
  return name.empty() ? fs::path(deck.file()).stem().string() : name;
}

}  // namespace tether::published
