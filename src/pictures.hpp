// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "option_checks.hpp"

namespace tether {

/// What is drawn by a script of post/, which reads the words once more: nothing is kept of them here.
struct Pictures {
  CLI::App *plot, *film, *compare, *page;

  explicit Pictures(CLI::App& app) {
    plot = add(app, "plot", "pictures of a run: its fields at some times, its histories", "folder for the pictures");
    option(plot, "--time", "a time to draw, repeated for each (default: evenly between start and end)");
    film = add(app, "film", "a film of a run", "the film's file");
    film->add_flag_callback(
        "--gif", [] {}, "a GIF in place of an MP4");
    option(film, "--frames", "the first pictures alone, so many");
    page = add(app, "page", "one HTML page of a run, with a slider over time", "the page's file");
    for (auto* of_fields : {plot, film, page})
      option(of_fields, "--field", "the field that colours show (default: what the scene is about)");
    compare =
        add(app, "compare", "two runs, or a run and a table of numbers, as figure and table", "folder for both", 2);
    option(compare, "--column", "a column of the histories, repeated for each (default: all)");
  }
  bool called() const { return *plot || *film || *compare || *page; }

 private:
  static CLI::App* add(CLI::App& app, const char* name, const char* meaning, const char* result, int count = 1) {
    auto* command = app.add_subcommand(name, meaning);
    command->add_option_function<std::vector<std::string>>("folder", nothing, "folder of a run")
        ->required()
        ->expected(count);
    command->add_option_function<std::string>("--out", one, std::string(result) + " (default: in the run's folder)")
        ->check(refuse_no_folder);
    return command;
  }
  static void option(CLI::App* command, const char* name, const char* meaning) {
    command->add_option_function<std::vector<std::string>>(name, nothing, meaning)->allow_extra_args(false);
  }
  static void nothing(const std::vector<std::string>&) {}
  static void one(const std::string&) {}
};

}  // namespace tether
