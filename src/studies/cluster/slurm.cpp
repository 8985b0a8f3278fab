// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/cluster/slurm.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "base/child.hpp"
#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "base/shell.hpp"
#include "base/text.hpp"
#include "results/text_file.hpp"

namespace tether::slurm {
namespace {

namespace fs = std::filesystem;

constexpr double shortest_job = 60;      // seconds: a job costs Slurm about one
constexpr std::size_t most_jobs = 1000;  // of one array, as Slurm's MaxArraySize has it by default
constexpr int most_restarts = 100;
constexpr int seconds_for_the_checkpoint = 120;

/// What plans expect is that of a machine like the one of their measurements; what is left of the time costs nothing.
long long minutes_for(double seconds) { return static_cast<long long>(std::ceil((2 * seconds + 600) / 60)); }
long long megabytes_for(double megabytes) { return static_cast<long long>(std::ceil(1.25 * megabytes + 200)); }

/// What sbatch reads, in which nothing stands that a user has named.
std::string heading(int cpus, double seconds, double megabytes, const std::string& more) {
  return fmt::format(
      "#!/bin/bash\n#SBATCH --job-name=tether\n#SBATCH --output=/dev/null\n{}"
      "#SBATCH --cpus-per-task={}\n#SBATCH --time={}\n#SBATCH --mem={}M\n"
      "#SBATCH --signal=B:TERM@{}\n#SBATCH --requeue\n",
      more, cpus, minutes_for(seconds), megabytes_for(megabytes), seconds_for_the_checkpoint);
}

/// The rest of a script. What the job says goes to a log in the results' folder; a machine that does not see it leaves
/// its word with Slurm and in a temporary file of its own. `wait` ends when the signal comes, and the run some time
/// after that. A job whose time is about to end still runs by Slurm's own word; one that a user has cancelled does not,
/// and stays so.
std::string body(const Work& work, const std::string& log, const std::string& job, const std::string& command) {
  const std::string folder = shell_word((work.folder / "slurm").string());
  return fmt::format(R"sh(
if ! cd {here} || ! [ -w {folder} ]; then
  why="$(hostname) does not see the folder of the results: use one that all machines share, or leave this one out by --exclude"
  echo "$why" > "$(mktemp --suffix=.tether-"$SLURM_JOB_ID")"
  scontrol update JobId="{job}" Comment="$why"
  exit 4
fi
exec >> {folder}/{log} 2>&1
echo "$(date '+%F %T') job $SLURM_JOB_ID on $(hostname)"
run=
trap '[ -n "$run" ] && kill -TERM "$run"' TERM
{command} &
run=$!
wait "$run"
code=$?
while kill -0 "$run" 2> /dev/null; do
  wait "$run"
  code=$?
done
echo "$(date '+%F %T') exit code $code"
state=$(squeue --noheader --format=%T --jobs="{job}")
if [ "$code" -eq 143 ] && [ "$state" = RUNNING ] && [ "${{SLURM_RESTART_COUNT:-0}}" -lt {restarts} ]; then
  scontrol requeue "{job}"
fi
exit "$code"
)sh",
                     fmt::arg("here", shell_word(work.here.string())), fmt::arg("folder", folder), fmt::arg("log", log),
                     fmt::arg("job", job), fmt::arg("command", command), fmt::arg("restarts", most_restarts));
}

bool is_on_the_path(const char* program) {
  const char* path = std::getenv("PATH");
  const std::string all = path == nullptr ? "" : path;
  for (std::size_t from = 0; from < all.size();) {
    const std::size_t to = std::min(all.find(':', from), all.size());
    if (::access((fs::path(all.substr(from, to - from)) / program).c_str(), X_OK) == 0) return true;
    from = to + 1;
  }
  return false;
}

/// Holds the number of the job that was submitted last.
fs::path number_file(const fs::path& folder) { return folder / "slurm" / "job.txt"; }

/// The number in what sbatch says, as in "Submitted batch job 7"; "" where there is none.
std::string number_in(const std::string& said) {
  constexpr std::string_view before = "Submitted batch job ";
  const std::size_t at = said.find(before);
  if (at == std::string::npos) return "";
  const std::string rest = said.substr(at + before.size());
  return rest.substr(0, rest.find_first_not_of("0123456789"));
}

}  // namespace

std::vector<Job> jobs_of(std::vector<PartCost> parts) {
  std::ranges::stable_sort(parts, std::greater{}, &PartCost::seconds);
  double total = 0;
  for (const PartCost& part : parts) total += part.seconds;
  const double least = std::max(shortest_job, total / static_cast<double>(most_jobs));
  const std::size_t most_parts = parts.size() / most_jobs + 1;  // of which nobody knows how long they take
  std::vector<Job> jobs;
  for (const PartCost& part : parts) {
    const bool is_full = !jobs.empty() && jobs.back().seconds >= least && jobs.back().parts.size() >= most_parts;
    if (jobs.empty() || is_full) jobs.emplace_back();
    jobs.back().parts.push_back(part.number);
    jobs.back().seconds += part.seconds;
    jobs.back().megabytes = std::max(jobs.back().megabytes, part.megabytes);
  }
  for (Job& job : jobs) std::ranges::sort(job.parts);
  return jobs;
}

std::string script_of(const Work& work, const std::vector<Job>& jobs) {
  double seconds = 0, megabytes = 0;
  std::vector<std::string> parts;
  for (const Job& job : jobs) {
    seconds = std::max(seconds, job.seconds), megabytes = std::max(megabytes, job.megabytes);
    parts.push_back(part_text(job.parts));
  }
  const std::string array = fmt::format("#SBATCH --array=1-{}\n", jobs.size());
  const std::string command = shell_command(work.command) + " --part \"${parts[SLURM_ARRAY_TASK_ID - 1]}\"";
  return heading(work.cpus, seconds, megabytes, array) +
         fmt::format(
             "# Parts of a study by tether: a line a job. The same command with --collect makes the tables.\n"
             "parts=(\n{}\n)\n",
             fmt::join(parts, "\n")) +
         body(work, "\"$SLURM_ARRAY_TASK_ID\".log", "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID", command);
}

std::string script_of(const Work& work, const Cost& cost) {
  return heading(work.cpus, cost.seconds, cost.megabytes, "") + "# A run by tether.\n" +
         body(work, "job.log", "$SLURM_JOB_ID", shell_command(work.command));
}

void refuse_no_slurm() {
  if (!is_on_the_path("sbatch"))
    throw InputError(
        "there is no Slurm on this machine: no folder of PATH has sbatch. --slurm --dry-run writes the script alone, "
        "--jobs and mpirun share the runs out without Slurm");
}

fs::path write_script(const Work& work, const std::string& script) {
  const fs::path folder = work.folder / "slurm";
  std::error_code reason;
  fs::create_directories(folder, reason);
  if (reason) throw FileError(fmt::format("{}: cannot be created: {}", folder.string(), reason.message()));
  replace_file(folder / "job.sh", script);
  return folder / "job.sh";
}

void refuse_queued(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::is_regular_file(number_file(folder), ignored)) return;
  const std::string number(trim(read_file(number_file(folder))));
  const auto [code, states] =
      said_by({"squeue", "--noheader", "--states=PENDING,RUNNING,SUSPENDED", "--format=%T", "--jobs=" + number});
  if (code == 0 && !trim(states).empty())
    throw InputError(fmt::format(
        "Slurm still has job {} of {}: wait until it has ended, or cancel it by scancel {}. --collect makes "
        "tables meanwhile",
        number, folder.string(), number));
}

std::string submit(const fs::path& script) {
  const auto [code, said] = said_by({"sbatch", script.string()});
  if (code != 0)
    throw FileError(fmt::format("sbatch does not take {}: exit code {}, {}", script.string(), code,
                                said.empty() ? "without a word" : said));
  if (const std::string number = number_in(said); !number.empty())
    replace_file(number_file(script.parent_path().parent_path()), number + "\n");
  return said;
}

}  // namespace tether::slurm
