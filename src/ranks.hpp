// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "base/letters.hpp"

namespace tether {

/// How many programs mpirun, or srun by MPI, has started of this command, and which one this is.
struct Launch {
  int rank = 0, size = 1;
};

/// Reads it from the environment, in which each MPI says so; none where this program was started alone. MPI itself is
/// not asked: a plain run does not wait for it.
std::optional<Launch> launch();

/// This program among those of its command.
struct Seat {
  int rank = 0, size = 1;
  std::unique_ptr<LetterBox> box;  ///< leads to the others
};

/// Has this process carry letters between the programs of the command, by MPI, and goes on in a child of it: what runs
/// fork from must not know of MPI. Throws InputError where this build has no MPI, FileError where MPI does not start.
Seat take_seat();

}  // namespace tether
