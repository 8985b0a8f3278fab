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
    plot = add(app, "plot", "pictures of a run, its fields and histories, or of a sweep, a chart or a map",
               "folder for the pictures");
    option(plot, "--time", "a time to draw, repeated for each (default: some that show the run)");
    option(plot, "--x", "of a sweep: the column of the abscissa (default: the first axis)");
    option(plot, "--y", "of a sweep: the column of the ordinate (default: each quantity)");
    option(plot, "--by", "of a sweep: the column of which each value has a line (default: the second axis)");
    plot->add_flag_callback(
        "--log", [] {}, "of a sweep: logarithmic scales");
    film = add(app, "film", "a film of a run", "the film's file");
    film->add_flag_callback(
        "--gif", [] {}, "a GIF in place of an MP4");
    option(film, "--frames", "how many pictures the film has, from the start on (default: all snapshots)");
    page = add(app, "page", "one HTML page of a run, with a slider over time", "the page's file");
    for (auto* of_fields : {plot, film, page})
      option(of_fields, "--field",
             "the field that colours show (default: what the scene is about), or of a liquid one colour, as 'crimson'");
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
