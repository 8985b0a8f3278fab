// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.hpp"

#include "base/text.hpp"
#include "commands.hpp"
#include "deck/deck.hpp"
#include "deck/spelling.hpp"
#include "option_checks.hpp"
#include "studies/runs/parts.hpp"

namespace tether {
namespace {

void add_deck_options(CLI::App& app, DeckOptions& options) {
  app.add_option("--set", options.overrides,
                 "takes the place of a deck's value, --set in.tmax=0.1 for example; --set is repeated for each value")
      ->option_text("GROUP.NAME=VALUE")
      ->allow_extra_args(false);
  app.add_option("--particles", options.particles, "particle file, in place of the one the deck names");
  app.add_option("--path", options.path, "solver path: mpm, fem, bars or coupled (default: what the deck's groups say)")
      ->check(CLI::IsMember(split_choices(AnyVariable("in.path").row())));
}

CLI::Option* add_auto(CLI::App& app, RunOptions& options) {
  const std::string meaning =
      "find the cheapest cells and steps that meet a relative tolerance for what the deck is to be true to "
      "($auto quantity='...'), by runs from coarse to fine";
  auto* option = app.add_option("--auto", options.tolerance, meaning)->option_text("TOL")->check(CLI::Number);
  return option->excludes(app.get_option("--particles"));  // points of a file cannot be made more
}

constexpr const char* one_a_core = "one for each core where that is faster";

void add_threads(CLI::App& app, int& threads, const std::string& otherwise) {
  app.add_option(
         "--threads", threads,
         "threads that share the work of a run (default: " + otherwise + "); results are the same for any number")
      ->check(CLI::Range(1, 1024));
}

/// Version and examples.
void describe(CLI::App& app) {
  app.set_version_flag("--version", version_text);
  app.footer(
      "Examples:\n  tether decks get sod && tether sod.in && tether plot out/sod    a first run, and its pictures\n"
      "  tether check my.in; tether plan my.in                          what a deck says, models and costs\n"
      "  tether my.in --set in.nx=201 --out out/fine                    the same scene on another grid\n");
  app.require_subcommand(0, 1);
}

CLI::Option* add_slurm(CLI::App& app, RunOptions& options) {
  return app.add_flag("--slurm", options.slurm,
                      "have Slurm do it: write the script of its jobs and submit it, or with --dry-run write it alone");
}

/// Adds what a run takes, which has no command's name before it.
void add_run(CLI::App& app, std::vector<std::string>& decks, DeckOptions& options, RunOptions& run_options) {
  auto* deck_names = app.add_option("deck", decks, "decks to run");
  add_deck_options(app, options);
  app.add_option("--out", run_options.out, "folder for the outputs (default out/<deck name>)")->check(refuse_no_folder);
  add_threads(app, run_options.threads, one_a_core);
  auto* tolerance = add_auto(app, run_options);
  app.add_option("--restart", run_options.restart, "checkpoint to go on from, of the same deck")
      ->needs(deck_names)
      ->excludes(tolerance)
      ->check(refuse_no_file);
  app.add_option("--log", run_options.log, "file for all that is said of the runs, also with --quiet")
      ->excludes(tolerance)
      ->check(refuse_no_file);
  app.add_flag("--quiet", run_options.quiet, "no progress, no warnings on the terminal");
  app.add_flag("--dry-run", run_options.dry_run, "read and plan, write nothing; of --slurm: submit nothing");
  app.add_flag("--continue", run_options.go_on,
               "go on from the newest checkpoint of this deck in the folder, if there is one")
      ->excludes(tolerance)
      ->excludes("--restart");
  add_slurm(app, run_options)->needs(deck_names)->excludes(tolerance)->excludes("--restart");
}

CLI::App* add_check(CLI::App& app, std::string& deck, DeckOptions& options, bool& all) {
  auto* check = app.add_subcommand("check", "list what a deck says: each value with its unit and its place");
  check->add_option("deck", deck, "the deck")->required();
  check->add_flag("--all", all, "every variable, also those that have their defaults or are not given");
  add_deck_options(*check, options);
  return check;
}

CLI::App* add_plan(CLI::App& app, std::string& deck, DeckOptions& options, RunOptions& run_options) {
  auto* plan = app.add_subcommand("plan", "say what will be modelled, what is left out and why, step and cost");
  plan->add_option("deck", deck, "the deck")->required();
  add_deck_options(*plan, options);
  add_threads(*plan, run_options.threads, one_a_core);
  auto* tolerance = add_auto(*plan, run_options);
  plan->add_option("--out", run_options.out, "folder for the runs of --auto (default out/<deck name>)")
      ->needs(tolerance)
      ->check(refuse_no_folder);
  return plan;
}

std::string refuse_no_parts(const std::string& text) {
  return part_numbers(text) ? "" : fmt::format("'{}' is no list of numbers from 1, such as 3,7-9", text);
}

/// Adds what all commands of many runs take.
void add_many_runs(CLI::App& app, RunOptions& options) {
  app.add_option("--jobs", options.jobs, "runs side by side (default: as many as there are cores for their threads)")
      ->check(CLI::Range(1, 1024));
  add_threads(app, options.threads, "1");
  app.add_flag("--quiet", options.quiet, "no progress, no table on the terminal");
  app.add_flag("--dry-run", options.dry_run,
               "list the runs and which are finished, run nothing; of --slurm: submit nothing");
  auto* list =
      app.add_flag("--list", options.list,
                   "print a command for each part (a run, or a bisection) that is not finished, for GNU parallel "
                   "or a script; --collect then makes the tables");
  auto* part = app.add_option("--part", options.parts, "do these parts alone, and leave the tables to --collect")
                   ->option_text("N,M-K")
                   ->check(refuse_no_parts);
  app.add_option("--of", options.parts_of, "refuse a study that is not the one with this sum, as --list gives it")
      ->option_text("SUM")
      ->needs(part);
  auto* collect = app.add_flag("--collect", options.collect, "make the tables of what is finished, run nothing");
  auto* slurm = add_slurm(app, options);
  for (auto* other : {list, part, collect}) other->excludes("--dry-run");
  for (auto* one : {list, part, collect, slurm}) {
    for (auto* other : {list, part, collect, slurm}) {
      if (one != other) one->excludes(other);
    }
  }
}

CLI::App* add_sweep(CLI::App& app, std::string& study, RunOptions& options) {
  auto* sweep = app.add_subcommand("sweep", "run a study deck: many runs, one table");
  sweep->add_option("study", study, "the study deck")->required();
  sweep->add_option("--out", options.out, "folder for the tables and the runs (default out/<study name>)")
      ->check(refuse_no_folder);
  add_many_runs(*sweep, options);
  return sweep;
}

CLI::App* add_chart(CLI::App& app, std::vector<std::string>& studies, RunOptions& options) {
  auto* chart =
      app.add_subcommand("chart", "run chart decks: error against cost over paths, methods, meshes and steps");
  chart->add_option("study", studies, "the chart decks")->required();
  chart
      ->add_option("--out", options.out,
                   "folder for table and runs, of several for their folders (default out/charts/<name>)")
      ->check(refuse_no_folder);
  add_many_runs(*chart, options);
  return chart;
}

CLI::App* add_map(CLI::App& app, std::vector<std::string>& studies, RunOptions& options) {
  auto* map = app.add_subcommand("map", "run map decks: where over one or two deck values a method holds");
  map->add_option("study", studies, "the map decks")->required();
  map->add_option("--out", options.out,
                  "folder for tables and runs, of several for their folders (default out/maps/<name>)")
      ->check(refuse_no_folder);
  add_many_runs(*map, options);
  return map;
}

/// A list that the program knows and the guide repeats.
CLI::App* add_listing(CLI::App& app, const std::string& name, const std::string& meaning, bool& markdown) {
  auto* listing = app.add_subcommand(name, meaning);
  listing->add_flag("--markdown", markdown, "as in decks/guide");
  return listing;
}

CLI::App* add_decks(CLI::App& app, std::vector<std::string>& words, std::string& into) {
  auto* decks = app.add_subcommand("decks", "list the decks that come with the program; decks get NAME copies one");
  decks->add_option("words", words, "get NAME")->expected(0, 2);
  decks->add_option("--out", into, "folder for the copies (default: this one)")->check(refuse_no_folder);
  return decks;
}

CLI::App* add_reproduce(CLI::App& app, PublishedOptions& published, RunOptions& options) {
  auto* reproduce =
      app.add_subcommand("reproduce", "run published problems, compare their numbers with this program's");
  reproduce->add_option("name", published.names,
                        "problems, or decks of your own that end with .in (default: all problems)");
  reproduce->add_option("--decks", published.decks, "folder of their decks (default decks, else those of the program)");
  reproduce->add_option("--write", published.write, "file for the table, as Markdown");
  reproduce->add_option("--out", options.out, "folder for the runs (default out/reproduce)")->check(refuse_no_folder);
  add_many_runs(*reproduce, options);
  return reproduce;
}

/// Adds what stands before all commands; returns the first of them.
CLI::App* add_run_and_check(CommandLine& line) {
  describe(line.app);
  add_run(line.app, line.decks, line.deck_options, line.run);
  return add_check(line.app, line.deck, line.deck_options, line.all);
}

}  // namespace

CommandLine::CommandLine()
    : app("tether: fluid and structure on one deck by material points or finite elements.\nExit codes: 0 done, 2 input "
          "wrong, 3 run diverged, 4 file trouble, 5 a bisection found nothing, a published number is missed or --auto "
          "cannot promise, 130 or 143 interrupted.",
          "tether"),
      check(add_run_and_check(*this)),
      plan(add_plan(app, deck, deck_options, run)),
      sweep(add_sweep(app, deck, run)),
      chart(add_chart(app, studies, run)),
      map(add_map(app, studies, run)),
      reproduce(add_reproduce(app, published, run)),
      pictures(app),
      shipped(add_decks(app, deck_words, into)),
      vars(add_listing(app, "vars", "the deck reference", markdown)),
      columns(add_listing(app, "columns", "the columns that histories may have", markdown)),
      keys(add_listing(app, "keys", "the keys that summaries may have", markdown)) {
  vars->add_option("group", group, "only this group");
}

}  // namespace tether
