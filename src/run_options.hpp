// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tether {

class Crew;

/// What the command line says of a run, or of many.
struct RunOptions {
  std::string out;                  ///< empty: out/<deck name>, out/charts/<name>, out/maps/<name>
  int threads = 0;                  ///< of a run; 0: as many as are worth it
  int jobs = 0;                     ///< runs of a sweep side by side
  std::string restart;              ///< checkpoint to go on from; empty: from the start
  std::string log;                  ///< file for all that the terminal shows; empty: none
  std::optional<double> tolerance;  ///< relative, of --auto; none: the deck's own setting is run
  bool quiet = false;
  bool dry_run = false;
  bool go_on = false;                   ///< from the newest checkpoint of the deck in the folder, if there is one
  bool list = false;                    ///< of a study: the command of each part, run nothing
  bool collect = false;                 ///< of a study: the tables of what is finished, run nothing
  bool slurm = false;                   ///< jobs of Slurm do the work
  std::string parts;                    ///< of a study: those to do, "3,7-9"; empty: all
  std::string parts_of;                 ///< the sum of the study whose parts they are; empty: not to be asked
  std::vector<std::string> words = {};  ///< of the command line, without the program
  std::string command;                  ///< as it was typed, for provenance
  Crew* others = nullptr;               ///< the other programs of this command, where mpirun has started some
};

/// Which published problems are wanted, and what is done with them next to what RunOptions say.
struct PublishedOptions {
  std::vector<std::string> names;  ///< none: all
  std::string decks;               ///< folder of their decks; "" for decks/ here, else the program's own
  std::string write;               ///< file for the table in Markdown; empty for none
};

}  // namespace tether
