// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <omp.h>
#include <unistd.h>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <csignal>
#include <string_view>
#include <thread>

#include "base/diagnostics.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "command_words.hpp"
#include "commands.hpp"
#include "deck/deck.hpp"
#include "deck/spelling.hpp"
#include "option_checks.hpp"
#include "pictures.hpp"
#include "study_commands.hpp"

// The command line: words in, one command called, its exit code out.

namespace {

using namespace tether;

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
  app.add_flag("--dry-run", run_options.dry_run, "read and plan, write nothing");
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

/// Adds what all commands of many runs take.
void add_many_runs(CLI::App& app, RunOptions& options) {
  app.add_option("--jobs", options.jobs, "runs side by side (default: as many as there are cores for their threads)")
      ->check(CLI::Range(1, 1024));
  add_threads(app, options.threads, "1");
  app.add_flag("--quiet", options.quiet, "no progress, no table on the terminal");
  app.add_flag("--dry-run", options.dry_run, "list the runs and which are finished, run nothing");
}

void share_cores(RunOptions& options) {
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  options.threads = std::max(1, options.threads);
  if (options.jobs == 0) options.jobs = std::max(1, cores / options.threads);
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

/// Outside of runs, which hold signals back, there is nothing to be kept: whatever is read or computed, they end it. Of
/// what a program may call here, write() says so.
extern "C" void end_by(int signal) {
  constexpr std::string_view by_int = "tether: interrupted by SIGINT while no run was under way\n",
                             by_term = "tether: interrupted by SIGTERM while no run was under way\n";
  const std::string_view text = signal == SIGINT ? by_int : by_term;
  if (write(STDERR_FILENO, text.data(), text.size()) < 0) _exit(exit_signal + signal);  // nowhere to say it
  _exit(exit_signal + signal);
}

/// Not where the caller wants a signal to be passed over.
void heed(int signal) {
  if (std::signal(signal, end_by) == SIG_IGN) std::signal(signal, SIG_IGN);
}

/// A file over the size limit is reported as a failed write, with exit code 4. A sweep hears of its runs' ends whatever
/// the caller left. What is printed where a standard stream is closed must not land in a file that takes its number.
/// CHOLMOD starts threads for each supernode, which for factors of this size costs more than it saves.
void settle_in() {
  keep_freed_memory();
  omp_set_max_active_levels(0);
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGCHLD, SIG_DFL);
  heed(SIGINT);
  heed(SIGTERM);
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
    if (fcntl(stream, F_GETFD) < 0) open("/dev/null", O_RDWR);  // takes the lowest number that is free
  }
}

/// Says what every wrong command line ends with.
int refuse(const std::string& why) {
  std::fputs(with_short_words(why).c_str(), stderr);
  return exit_input;
}

/// Neither a deck nor a command was given.
int refuse_nothing(const CLI::App& app) {
  return refuse(
      fmt::format("tether: error: a deck or a command is missing\n  tether DECK runs a deck. The commands are "
                  "{}; tether --help says what they do.\n",
                  command_names(app)));
}

std::string typed(int argc, char** argv) {
  std::string command;
  for (int k = 0; k < argc; ++k) command += (k ? " " : "") + std::string(argv[k]);
  return command;
}

/// Reads the words, which may stand in any order after the command, and puts them into their order; -1 where there is
/// something to do.
int parse(CLI::App& app, std::vector<std::string>& words) {
  try {
    words = ordered_words(app, words);
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // as the parser takes them
    return -1;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    const auto called = app.get_subcommands();
    const std::string who = called.empty() ? "tether" : "tether " + called.front()->get_name();
    return refuse(fmt::format("{}: error: {}\n  {} --help lists what is expected.\n", who, error.what(), who));
  } catch (const InputError& error) {
    return refuse(fmt::format("tether: {}", error.what()));
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "tether: fluid and structure on one deck by material points or finite elements.\nExit codes: 0 done, 2 input "
      "wrong, 3 run "
      "diverged, 4 file trouble, 5 a bisection found nothing, a published number is missed or --auto cannot promise, "
      "130 or 143 interrupted.",
      "tether");
  describe(app);

  DeckOptions options;
  RunOptions run_options;
  std::vector<std::string> decks;
  add_run(app, decks, options, run_options);
  std::string deck, group;
  std::vector<std::string> studies;
  bool markdown = false, all = false;
  auto* check = add_check(app, deck, options, all);
  auto* plan = add_plan(app, deck, options, run_options);
  auto* sweep = add_sweep(app, deck, run_options);
  auto* chart = add_chart(app, studies, run_options);
  auto* map = add_map(app, studies, run_options);
  PublishedOptions published;
  auto* reproduce = add_reproduce(app, published, run_options);
  const Pictures pictures(app);
  std::vector<std::string> deck_words;
  std::string into;
  auto* shipped = add_decks(app, deck_words, into);
  auto* vars = add_listing(app, "vars", "the deck reference", markdown);
  vars->add_option("group", group, "only this group");
  auto* columns = add_listing(app, "columns", "the columns that histories may have", markdown);
  auto* keys = add_listing(app, "keys", "the keys that summaries may have", markdown);

  std::vector<std::string> words(argv + 1, argv + argc);
  if (const int code = parse(app, words); code >= 0) return code;
  if (pictures.called()) return script_command(words.front(), {words.begin() + 1, words.end()});
  settle_in();
  run_options.command = typed(argc, argv);
  if (*check) return check_command(deck, options, all);
  if (run_options.tolerance) share_cores(run_options);
  if (*plan && run_options.tolerance) return auto_plan_command(deck, options, run_options);
  if (*plan) return plan_command(deck, options, run_options.threads);
  if (*sweep || *chart || *map || *reproduce) share_cores(run_options);
  if (*sweep) return sweep_command(deck, run_options);
  if (*chart) return chart_command(studies, run_options);
  if (*map) return map_command(studies, run_options);
  if (*reproduce) return reproduce_command(published, run_options);
  if (*shipped) return decks_command(deck_words, into);
  if (*vars) return vars_command(group, markdown);
  if (*columns) return columns_command(markdown);
  if (*keys) return keys_command(markdown);
  if (decks.empty()) return refuse_nothing(app);
  if (run_options.tolerance) return auto_command(decks, options, run_options);
  return run_command(decks, options, run_options);
}
