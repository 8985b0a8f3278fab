// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <boost/mpi/communicator.hpp>
#include <boost/mpi/request.hpp>
#include <chrono>
#include <list>
#include <string>
#include <vector>

#include "base/letters.hpp"

namespace tether {

/// Carries the letters of one program to those of the other ranks, and theirs to it. It looks often while there is
/// traffic, and seldom while there is none, since MPI itself would wait at full speed. Each rank sends a beat to rank 0
/// now and then, and rank 0 to each: one that falls silent is lost, as is one whose program has ended. Of such a one
/// the program of rank 0 gets an empty letter; without rank 0 all end.
class PostOffice {
 public:
  /// The socket leads to the program that is served, a child of this process. The communicator must outlive this.
  PostOffice(boost::mpi::communicator& world, int socket, pid_t served);

  /// Until the program has ended, and on other ranks than 0 until rank 0 says so, or is lost. Returns the exit code.
  int carry();
  /// Returns whether no rank was lost.
  bool all_are_here() const { return all_are_here_; }

 private:
  using Clock = std::chrono::steady_clock;
  struct Sending {
    std::string bytes;
    boost::mpi::request request;
  };
  void wait_for_the_program();
  void take_from_program();
  void take_from_ranks();
  void send(int rank, int tag, std::string bytes);
  void drop_what_has_gone();
  void beat();
  void lose_the_silent();
  void lose(std::size_t rank);
  void end_the_program(bool all_are_here);
  void end_without_the_first();
  void look_at_the_program();
  void end_all();
  int exit_code() const;

  boost::mpi::communicator& world_;
  LetterBox box_;
  pid_t served_;
  bool program_has_ended_ = false, is_told_to_end_ = false, all_are_here_ = true, first_is_lost_ = false;
  int status_ = 0;  // of the program, as wait() has it
  std::list<Sending> sendings_;
  std::vector<Clock::time_point> last_heard_;  // of each rank; other ranks than 0 hear of rank 0 alone
  std::vector<bool> is_lost_;
  Clock::time_point last_traffic_ = Clock::now(), last_beat_ = last_traffic_;
};

}  // namespace tether
