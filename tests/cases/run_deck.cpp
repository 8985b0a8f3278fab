// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/run_deck.hpp"

#include <gtest/gtest.h>
#include <netcdf.h>
#include <unistd.h>

#include <filesystem>

#include "deck/reader.hpp"
#include "plan/load.hpp"
#include "run/run.hpp"

namespace tether::cases {

namespace {

DeckRun run_loaded(const std::string& name, const Loaded& loaded) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = std::filesystem::path(testing::TempDir()) /
                      ("tether-" + std::to_string(getpid()) + "-" + test->name() + "-" + name);
  RunRequest request;
  request.folder = folder;
  request.deck_effective = loaded.effective;
  std::vector<std::string> messages;
  request.warn = [&messages](const std::string& text) { messages.push_back(text); };
  const std::shared_ptr<void> keeps_folder(nullptr, [folder](void*) { std::filesystem::remove_all(folder); });
  const RunOutcome outcome = run(loaded.plan, request);
  DeckRun result{{}, outcome.history, loaded.plan.warnings, messages, folder.string(), keeps_folder};
  for (const auto& [key, value] : outcome.summary) {
    if (key != "path" && key != "linear_solver" && key != "mode") result.summary[key] = std::stod(value);
  }
  return result;
}

}  // namespace

DeckRun run_deck(const std::string& name, const std::vector<std::string>& overrides) {
  return run_loaded(name, load(std::string(TETHER_SOURCE_DIR) + "/decks/" + name + ".in", {overrides, "", ""}));
}

DeckRun run_file(const std::string& path, const std::vector<std::string>& overrides) {
  return run_loaded(std::filesystem::path(path).stem().string(), load(path, {overrides, "", ""}));
}

DeckRun run_text(const std::string& name, const std::string& text, const std::vector<std::string>& overrides) {
  Diagnostics diagnostics;
  const Deck deck = read_deck(text, name + ".in", overrides, diagnostics);
  return run_loaded(name, load_scene(deck, {overrides, "", ""}, diagnostics));
}

DeckRun run_by(const std::string& path, const std::string& deck, std::vector<std::string> overrides) {
  overrides.push_back("in.path='" + path + "'");
  return run_file(std::string(TETHER_SOURCE_DIR) + "/decks/paths/" + deck + ".in", overrides);
}

std::vector<std::string> with(std::vector<std::string> some, const std::vector<std::string>& more) {
  some.insert(some.end(), more.begin(), more.end());
  return some;
}

std::vector<double> read_variable(const std::string& file, const std::string& name) {
  int id = 0, variable = 0, dimensions = 0;
  EXPECT_EQ(nc_open(file.c_str(), NC_NOWRITE, &id), NC_NOERR) << file;
  EXPECT_EQ(nc_inq_varid(id, name.c_str(), &variable), NC_NOERR) << name;
  nc_inq_varndims(id, variable, &dimensions);
  std::vector<int> ids(static_cast<std::size_t>(dimensions));
  nc_inq_vardimid(id, variable, ids.data());
  std::size_t total = 1;
  for (const int dimension : ids) {
    std::size_t length = 0;
    nc_inq_dimlen(id, dimension, &length);
    total *= length;
  }
  std::vector<double> values(total);
  EXPECT_EQ(nc_get_var_double(id, variable, values.data()), NC_NOERR);
  nc_close(id);
  return values;
}

}  // namespace tether::cases
