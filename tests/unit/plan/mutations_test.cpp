// SPDX-License-Identifier: GPL-3.0-or-later
// Every byte of every printed deck and of every particle file, left out or written twice, on its way to a run: it ends
// in a plan or in an InputError. Of long files, whose rows are those of a short one, every seventh byte by default: all
// columns are met.
#include <cstdio>

#include "base/file.hpp"
#include "plan/load.hpp"
#include "unit/full_length.hpp"
#include "unit/temporary_folder.hpp"

namespace tether::test {
namespace {

/// A deck and the particle file it is read with, relative to the tree; empty: none.
struct Pair {
  std::string deck, particles;
};

void PrintTo(const Pair& pair, std::ostream* out) { *out << pair.deck << " with " << pair.particles; }

std::string in_tree(const std::string& name) { return name.empty() ? "" : std::string(TETHER_SOURCE_DIR) + "/" + name; }

struct Counts {
  int planned = 0, refused = 0;
};

void load_once(const std::string& deck, const std::string& particles, Counts& counts) {
  try {
    load(deck, {{}, particles, "mpm"});
    ++counts.planned;
  } catch (const InputError& error) {
    EXPECT_FALSE(error.diagnostics().empty());
    ++counts.refused;
  }
}

class Mutations : public TemporaryFolder, public testing::WithParamInterface<Pair> {
 protected:
  /// Calls `read` with the name of a file that holds `original` changed, once for each change.
  template <typename Read>
  void mutate(const std::string& original, Read read) {
    const auto text = read_file(in_tree(original));
    const std::string file = folder / "mutated";
    Counts counts;
    const std::size_t stride = text.size() < 10000 || at_full_length() ? 1 : 7;
    for (std::size_t k = 0; k < text.size(); k += stride) {
      for (const bool twice : {false, true}) {
        SCOPED_TRACE(testing::Message() << "byte " << k << (twice ? " twice" : " left out"));
        auto mutated = text;
        twice ? mutated.insert(k, 1, text[k]) : mutated.erase(k, 1);
        std::filesystem::remove(file);  // writing over it would wait for the disk
        write_file(file, mutated);
        ASSERT_NO_THROW(read(file, counts));
      }
    }
    std::printf("%s: %zu changes, %d with a plan, %d refused\n", original.c_str(), 2 * ((text.size() - 1) / stride + 1),
                counts.planned, counts.refused);
  }
};

class MutatedDeck : public Mutations {};

TEST_P(MutatedDeck, IsPlannedOrRefused) {
  const auto particles = in_tree(GetParam().particles);
  mutate(GetParam().deck, [&](const std::string& deck, Counts& counts) { load_once(deck, particles, counts); });
}

class MutatedParticles : public Mutations {};

TEST_P(MutatedParticles, ArePlannedOrRefused) {
  const auto deck = in_tree(GetParam().deck);
  mutate(GetParam().particles,
         [&](const std::string& particles, Counts& counts) { load_once(deck, particles, counts); });
}

std::vector<Pair> boxes_with_particles() {
  const std::string boxes = "tests/thesis-boxes/";
  return {{boxes + "box03_springmass.in", boxes + "box04_springmass.par"},
          {boxes + "box03_springmass.in", boxes + "box05_stringmass.par"},
          {boxes + "box06_pendulum.in", boxes + "box07_pendulum.par"},
          {boxes + "box09_membrane.in", boxes + "box09_membrane.par"},
          {boxes + "box12_piston.in", boxes + "box13_piston.par"},
          {boxes + "box14_stability.in", boxes + "box14_stability.par"}};
}

std::vector<Pair> boxes_alone() {
  std::vector<Pair> pairs;
  for (const auto& entry : std::filesystem::directory_iterator(in_tree("tests/thesis-boxes"))) {
    if (entry.path().extension() != ".in") continue;
    pairs.push_back({"tests/thesis-boxes/" + entry.path().filename().string(), ""});
  }
  return pairs;
}

std::vector<Pair> published_particles() {
  return {{"decks/noise.in", "particles/noise.par"},
          {"decks/pendulum-20.in", "particles/pendulum-20.par"},
          {"decks/pendulum-40.in", "particles/pendulum-40.par"},
          {"decks/pendulum-80.in", "particles/pendulum-80.par"},
          {"decks/pendulum-320.in", "particles/pendulum-320.par"},
          {"decks/piston-m1.in", "particles/piston.par"},
          {"decks/spring-mass.in", "particles/spring-mass.par"},
          {"decks/stability-centre.in", "particles/stability-centre.par"},
          {"decks/stability-side.in", "particles/stability-side.par"},
          {"decks/string-mass.in", "particles/string-mass.par"}};
}

INSTANTIATE_TEST_SUITE_P(Boxes, MutatedDeck, testing::ValuesIn(boxes_alone()));
INSTANTIATE_TEST_SUITE_P(BoxesWithParticles, MutatedDeck, testing::ValuesIn(boxes_with_particles()));
INSTANTIATE_TEST_SUITE_P(Boxes, MutatedParticles, testing::ValuesIn(boxes_with_particles()));
INSTANTIATE_TEST_SUITE_P(Published, MutatedParticles, testing::ValuesIn(published_particles()));

}  // namespace
}  // namespace tether::test
