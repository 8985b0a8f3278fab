// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <omp.h>
#include <unistd.h>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <csignal>
#include <memory>
#include <string_view>
#include <thread>

#include "base/diagnostics.hpp"
#include "base/process.hpp"
#include "base/shell.hpp"
#include "base/text.hpp"
#include "command_line.hpp"
#include "command_support.hpp"
#include "command_words.hpp"
#include "commands.hpp"
#include "ranks.hpp"
#include "results/checkpoint.hpp"
#include "studies/runs/remote_crew.hpp"
#include "study_commands.hpp"

// The command line: words in, one command called, its exit code out.

namespace {

using namespace tether;

void share_cores(RunOptions& options) {
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  options.threads = std::max(1, options.threads);
  const bool is_for_others = options.slurm || options.list || !options.parts.empty();  // who share the runs themselves
  if (options.jobs == 0) options.jobs = is_for_others ? 1 : std::max(1, cores / options.threads);
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

/// A single run takes threads, not programs; the first program says it. The others do not fail: mpirun ends all
/// programs as soon as one has, maybe before the first has spoken.
int refuse_to_split(const Launch& launch) {
  if (launch.rank > 0) return exit_done;
  return refuse(fmt::format(
      "tether: error: mpirun started {} programs for a run\n  mpirun deals out the runs of sweep, chart, map, "
      "reproduce and --auto; a single run shares its work among --threads.\n",
      launch.size));
}

/// Takes a seat among the programs that mpirun has started of one command; all but the first do runs for that one, and
/// end with the exit code that is returned. -1 where the command is this program's to do.
int join(CommandLine& line, const Launch& launch, std::unique_ptr<RemoteCrew>& others) {
  if (!line.makes_many_runs()) return line.decks.empty() ? -1 : refuse_to_split(launch);
  int served = -1;
  const int code = guarded("tether", [&] {
    const std::string program = this_program() + " " + shell_command(line.run.words);
    Seat seat = take_seat();
    if (seat.rank > 0) {
      served = serve(*seat.box, program);
      return;
    }
    others = std::make_unique<RemoteCrew>(std::move(seat.box), seat.size - 1);
    others->meet(program);
  });
  line.run.others = others.get();
  return code == exit_done ? served : code;
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
  CommandLine line;
  RunOptions& options = line.run;
  std::vector<std::string> words(argv + 1, argv + argc);
  if (const int code = parse(line.app, words); code >= 0) return code;
  if (line.pictures.called()) return script_command(words.front(), {words.begin() + 1, words.end()});
  settle_in();
  options.command = typed(argc, argv), options.words = words;
  if (*line.check) return check_command(line.deck, line.deck_options, line.all);
  std::unique_ptr<RemoteCrew> others;
  if (const auto started = launch(); started && started->size > 1) {
    if (const int code = join(line, *started, others); code >= 0) return code;
  }
  if (line.makes_many_runs()) share_cores(options);
  if (*line.plan && options.tolerance) return auto_plan_command(line.deck, line.deck_options, options);
  if (*line.plan) return plan_command(line.deck, line.deck_options, options.threads);
  if (*line.sweep) return sweep_command(line.deck, options);
  if (*line.chart) return chart_command(line.studies, options);
  if (*line.map) return map_command(line.studies, options);
  if (*line.reproduce) return reproduce_command(line.published, options);
  if (*line.shipped) return decks_command(line.deck_words, line.into);
  if (*line.vars) return vars_command(line.group, line.markdown);
  if (*line.columns) return columns_command(line.markdown);
  if (*line.keys) return keys_command(line.markdown);
  if (line.decks.empty()) return refuse_nothing(line.app);
  if (options.tolerance) return auto_command(line.decks, line.deck_options, options);
  return run_command(line.decks, line.deck_options, options);
}
