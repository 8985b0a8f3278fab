// SPDX-License-Identifier: GPL-3.0-or-later
#include "ranks.hpp"

#include <fmt/format.h>
#include <sys/socket.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "base/child.hpp"
#include "base/diagnostics.hpp"
#include "base/numbers.hpp"
#include "base/process.hpp"

namespace tether {
namespace {

/// The number in a variable of the environment; none where there is no such number.
std::optional<int> number_in(const char* variable) {
  const char* text = std::getenv(variable);
  const auto number = parse_integer(text == nullptr ? "" : text);
  return number ? std::optional(static_cast<int>(*number)) : std::nullopt;
}

/// The variables of Open MPI; of MPICH and Intel MPI; of srun with PMIx.
struct Variables {
  const char *rank, *size;
};
constexpr std::array known{Variables{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"}, Variables{"PMI_RANK", "PMI_SIZE"},
                           Variables{"PMIX_RANK", "SLURM_STEP_NUM_TASKS"}};

/// The program that carries letters: it stands next to this one, or where an installed program has its helpers.
std::filesystem::path carrier() {
  std::error_code reason;
  const auto folder = std::filesystem::read_symlink("/proc/self/exe", reason).parent_path();
  for (const char* way : {".", "../libexec/tether"}) {
    const auto program = (folder / way / "tether-mpi").lexically_normal();
    if (::access(program.c_str(), X_OK) == 0) return program;
  }
  throw InputError(
      "this build of tether has no MPI: it was built where libboost-mpi-dev was not installed. Build it where it is, "
      "or leave mpirun out: --jobs shares the runs out on this machine, --slurm on those of a cluster");
}

[[noreturn]] void carry(const std::filesystem::path& program, int socket, pid_t served) {
  std::array words{program.string(), fmt::format("{}", socket), fmt::format("{}", served)};
  std::array<char*, 4> arguments{words[0].data(), words[1].data(), words[2].data(), nullptr};
  ::execv(program.c_str(), arguments.data());
  std::fputs(fmt::format("{}: cannot be started: {}\n", program.string(), std::strerror(errno)).c_str(), stderr);
  _exit(exit_file);
}

/// The first letter says which program this is.
Seat seat_by(std::unique_ptr<LetterBox> box) {
  const auto letter = box->wait();
  if (!letter) throw FileError("MPI did not start, see above");
  Packed parts(letter->text);
  const int size = static_cast<int>(parts.take_number());
  return {letter->who, size, std::move(box)};
}

}  // namespace

std::optional<Launch> launch() {
  for (const auto& [rank, size] : known) {
    const auto mine = number_in(rank), all = number_in(size);
    if (mine && all) return Launch{*mine, *all};
  }
  return std::nullopt;
}

Seat take_seat() {
  const auto program = carrier();
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0)
    throw FileError(fmt::format("no socket can be made: {}", std::strerror(errno)));
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child < 0) throw FileError(fmt::format("no process can be started: {}", std::strerror(errno)));
  if (child > 0) {
    close(ends[1]);
    carry(program, ends[0], child);
  }
  close(ends[0]);
  if (!end_with_parent(parent)) _exit(exit_file);
  return seat_by(std::make_unique<LetterBox>(ends[1]));
}

}  // namespace tether
