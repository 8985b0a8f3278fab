// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/wait.h>
#include <unistd.h>

#include <boost/mpi/environment.hpp>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "base/child.hpp"
#include "base/process.hpp"
#include "mpi/post_office.hpp"

// tether-mpi SOCKET PID: carries letters between a program of tether, whose parent this process is and whose end of a
// socket pair it has, and the same of all other processes that mpirun started. Ends when the program ends, with its
// exit code; where mpirun dies, at once.

namespace {

/// Open MPI ends with exit code 0 where it is to go on without ranks that are lost.
void say(int code) {
  const char* recovery = std::getenv("OMPI_MCA_orte_enable_recovery");
  if (code != tether::exit_done && recovery != nullptr && std::strcmp(recovery, "1") == 0)
    std::fprintf(stderr, "tether: ends with exit code %d, though mpirun with --enable-recovery ends with 0\n", code);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return EXIT_FAILURE;
  if (!tether::end_with_parent(getppid())) return EXIT_FAILURE;
  const int socket = std::atoi(argv[1]);
  const pid_t served = std::atoi(argv[2]);
  boost::mpi::environment environment(false);  // what goes wrong is an exception here
  boost::mpi::communicator world;
  tether::PostOffice office(world, socket, served);
  const int code = office.carry();
  say(code);
  if (!office.all_are_here()) std::_Exit(code);  // to end MPI in order takes all
  return code;
}
