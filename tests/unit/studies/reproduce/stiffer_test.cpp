// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "base/file.hpp"
#include "deck/reader.hpp"
#include "plan/load.hpp"
#include "unit/studies/reproduce/support.hpp"

namespace tether::published {
namespace {

namespace fs = std::filesystem;

/// What is raised by a tenth.
enum class Raised { nothing, E, siep };

/// Of the noise of a point that changes cells all that is printed is the state it begins with, and of the longest step
/// the Courant number: neither depends on a modulus.
const std::set<std::string> without_modulus{"cylinder-file", "noise", "stability-centre", "stability-side"};

/// A problem's deck, written without a run: what it makes exact and states is judged by itself.
class Stiffer : public test::TemporaryFolder {
 protected:
  RunFiles posed(const Problem& problem, Raised raised) {
    const fs::path file = problem.deck;
    DeckOptions options;
    options.overrides = overrides(problem, raised);
    Diagnostics diagnostics;
    const Deck deck = load_deck(file.string(), options, diagnostics);
    const std::string particles = deck.text("in.particles");
    if (!particles.empty() && raised == Raised::E) options.particles = stiffer_points(file.parent_path() / particles);
    const fs::path run = folder / problem.name / std::to_string(static_cast<int>(raised));
    fs::create_directories(run);
    write_file(run / "deck.effective", load(file.string(), options).effective);
    return RunFiles(run);
  }

  /// Judged rows that disagree by the deck alone; rows that need a run do not count.
  std::vector<std::string> disagreeing(const Problem& problem, Raised raised) {
    const RunFiles run = posed(problem, raised);
    std::vector<std::string> rows;
    for (const PublishedQuantity& quantity : problem.quantities) {
      const bool by_robust = quantity.by_published == Judged::robust;
      const MethodResult alone{{run}, 1, "", {run}};
      const Judgement judgement =
          judge(quantity, by_robust ? MethodResult{} : alone, by_robust ? alone : MethodResult{});
      const Verdict& of_method = by_robust ? judgement.robust : judgement.thesis;
      const bool no_run = of_method.text.starts_with("no value");
      if (judgement.theory.standing == Standing::differs || (!no_run && of_method.standing == Standing::differs))
        rows.push_back(problem.name + ", " + quantity.name + ": " + judgement.text());
    }
    return rows;
  }

  static bool has_gas(const RunFiles& run) {
    const auto& bodies = run.scene().bodies;
    return std::any_of(bodies.begin(), bodies.end(),
                       [](const Body& body) { return std::holds_alternative<IdealGas>(body.material); });
  }
  static bool has_solids(const RunFiles& run) {
    const auto& bodies = run.scene().bodies;
    return std::any_of(bodies.begin(), bodies.end(),
                       [](const Body& body) { return !std::holds_alternative<IdealGas>(body.material); });
  }

 private:
  std::vector<std::string> overrides(const Problem& problem, Raised raised) {
    const std::string file = problem.deck;
    Diagnostics diagnostics;
    const Deck deck = load_deck(file, {}, diagnostics);
    std::vector<std::string> sets;
    const auto raise = [&](RealVariable name, int i, int j, const std::string& element) {
      if (deck.given(name, i, j))
        sets.push_back(std::string(name.group()) + "." + element + "=" + std::to_string(1.1 * deck.real(name, i, j)));
    };
    for (int k = 1; k <= 4; ++k) {
      const std::string at = std::to_string(k);
      if (raised == Raised::siep) raise("fluid.siep", k, 1, "siep(" + at + ")");
      if (raised == Raised::E) raise("reg.matr", 1, k, "matr(1," + at + ")");
      if (raised == Raised::E) raise("membrane.young", k, 1, "young(" + at + ")");
    }
    return sets;
  }

  /// The first number of a particle file's second line.
  std::string stiffer_points(const fs::path& file) {
    std::string text = read_file(file);
    const auto begin = text.find('\n') + 1, end = text.find(',', begin);
    std::string number = text.substr(begin, end - begin);
    std::replace(number.begin(), number.end(), 'd', 'e');
    text.replace(begin, end - begin, std::to_string(1.1 * std::stod(number)));
    const fs::path written = folder / "stiffer.par";
    write_file(written, text);
    return written.string();
  }
};

TEST_F(Stiffer, NoDeckDisagreesWithTheProblemThatItPoses) {
  for (const Problem& problem : all_problems()) {
    EXPECT_EQ(disagreeing(problem, Raised::nothing), std::vector<std::string>{}) << problem.name;
  }
}

/// With E or siep a tenth up at least one row of every problem that has it disagrees, whatever its runs show.
TEST_F(Stiffer, EveryProblemDisagreesWithATenthMore) {
  std::size_t raised = 0;
  for (const Problem& problem : all_problems()) {
    if (without_modulus.contains(problem.name)) continue;
    const RunFiles run = posed(problem, Raised::nothing);
    for (const Raised what : {Raised::E, Raised::siep}) {
      if (what == Raised::E ? !has_solids(run) : !has_gas(run)) continue;
      EXPECT_FALSE(disagreeing(problem, what).empty()) << problem.name << (what == Raised::E ? ", E" : ", siep");
      ++raised;
    }
  }
  EXPECT_GE(raised, 35u);
}

}  // namespace
}  // namespace tether::published
