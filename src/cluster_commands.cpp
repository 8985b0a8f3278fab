// SPDX-License-Identifier: GPL-3.0-or-later
#include "cluster_commands.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <numeric>
#include <string_view>
#include <utility>

#include "base/diagnostics.hpp"
#include "base/shell.hpp"
#include "studies/cluster/slurm.hpp"
#include "studies/runs/parts.hpp"
#include "studies/sweep.hpp"

namespace tether {
namespace {

namespace fs = std::filesystem;

/// The words of the command line without those that say who is to do it, by the program's own path. Options may follow:
/// names that begin with a hyphen, which stand after "--", are written as paths.
std::vector<std::string> command_alone(const RunOptions& options) {
  constexpr std::array<std::string_view, 5> of_others{"--slurm", "--list", "--dry-run", "--quiet", "--continue"};
  std::vector<std::string> words{fs::read_symlink("/proc/self/exe").string()};
  const auto names = std::ranges::find(options.words, "--");
  for (auto word = options.words.begin(); word != names; ++word) {
    if (std::ranges::find(of_others, *word) == of_others.end()) words.push_back(*word);
  }
  for (auto name = names; name != options.words.end(); ++name) {
    if (name != names) words.push_back(name->starts_with('-') ? "./" + *name : *name);
  }
  words.emplace_back("--quiet");
  return words;
}

/// The command that does parts of studies, but for their numbers.
std::vector<std::string> command_of_parts(const std::vector<StudyRun>& studies, const RunOptions& options) {
  auto words = command_alone(options);
  words.insert(words.end(), {"--of", sum_of(studies)});
  return words;
}

/// A line a part: with GNU parallel each line is a command.
void list_parts(const std::vector<StudyRun>& studies, const RunOptions& options) {
  const std::string command = shell_command(command_of_parts(studies, options));
  if (command.find('\n') != std::string::npos)
    throw InputError("a name in the command has a line end: its commands cannot be listed a line each");
  for (const std::size_t part : unfinished_parts(studies)) fmt::print("{} --part {}\n", command, part);
}

slurm::Work work_of(const fs::path& folder, std::vector<std::string> command, const RunOptions& options) {
  return {.folder = fs::absolute(folder),
          .here = fs::current_path(),
          .command = std::move(command),
          .cpus = std::max(1, options.threads) * std::max(1, options.jobs)};
}

/// Before plans take their time. A script alone needs no Slurm.
void refuse_what_slurm_cannot_do(const fs::path& folder, const RunOptions& options) {
  if (options.dry_run) return;
  slurm::refuse_no_slurm();
  slurm::refuse_queued(fs::absolute(folder));
}

/// Returns what is said at the end.
std::string hand_over(const slurm::Work& work, const std::string& script, const RunOptions& options) {
  const fs::path file = slurm::write_script(work, script);
  if (options.dry_run) return fmt::format("sbatch {}\n", shell_word(file.string()));
  return slurm::submit(file);
}

void hand_over_parts(const std::string& name, const std::vector<StudyRun>& studies, const fs::path& folder,
                     const RunOptions& options) {
  refuse_what_slurm_cannot_do(folder, options);
  const auto parts = unfinished_parts(studies);
  if (parts.empty()) return fmt::print("{}: all is finished; --collect makes the tables\n", name);
  const auto jobs = slurm::jobs_of(costs_of(studies, parts));
  const double seconds = std::accumulate(jobs.begin(), jobs.end(), 0.,
                                         [](double sum, const slurm::Job& job) { return sum + job.seconds; });
  const slurm::Work work = work_of(folder, command_of_parts(studies, options), options);
  const std::string said = hand_over(work, slurm::script_of(work, jobs), options);
  fmt::print("{}: parts: {}, jobs: {}, CPU seconds as plans have it: {:.3g}; --collect makes the tables\n{}", name,
             parts.size(), jobs.size(), seconds, said);
}

}  // namespace

bool is_done_otherwise(const std::string& name, const std::function<std::vector<StudyRun>()>& studies,
                       const StudyOptions& how, const RunOptions& options) {
  if (options.slurm)
    hand_over_parts(name, studies(), how.out, options);
  else if (options.list)
    list_parts(studies(), options);
  else if (options.dry_run)
    fmt::print("{}", list_runs(studies()));
  else if (how.doing == Doing::parts)
    do_parts(studies(), how, name, options.parts_of);
  else
    return false;
  return true;
}

void hand_over_run(const std::string& name, const Cost& cost, const fs::path& folder, const RunOptions& options) {
  refuse_what_slurm_cannot_do(folder, options);
  auto command = command_alone(options);
  command.emplace_back("--continue");
  if (options.threads == 0) command.insert(command.end(), {"--threads", "1"});
  const slurm::Work work = work_of(folder, std::move(command), options);
  const std::string said = hand_over(work, slurm::script_of(work, cost), options);
  fmt::print("{}: {:.3g} CPU seconds as its plan has it\n{}", name, cost.seconds, said);
}

void refuse_parts_of_several(const std::vector<std::string>& studies, const RunOptions& options) {
  if (studies.size() > 1 && (options.list || options.slurm || !options.parts.empty()))
    throw InputError("--list, --part and --slurm take one study at a time");
}

}  // namespace tether
