// SPDX-License-Identifier: GPL-3.0-or-later
#include "mpi/post_office.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <boost/mpi/exception.hpp>
#include <boost/mpi/status.hpp>
#include <csignal>
#include <cstdio>

#include "base/process.hpp"

namespace tether {
namespace {

using namespace std::chrono_literals;

enum Tag : int { letter, heartbeat, end };

constexpr auto between_beats = 1s;
constexpr auto longest_silence = 20s;  // of a rank that is there: its machine may be busy
constexpr auto shortest_look = std::chrono::microseconds(50), longest_look = std::chrono::microseconds(10'000);
constexpr double share_of_idle_time = 0.02;  // that a look may come late

/// The signal is the program's: it ends when it has written what is to be kept, and this process with it.
void leave_signals_to_the_program() {
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_IGN);
}

}  // namespace

PostOffice::PostOffice(boost::mpi::communicator& world, int socket, pid_t served)
    : world_(world),
      box_(socket),
      served_(served),
      last_heard_(static_cast<std::size_t>(world.size()), Clock::now()),
      is_lost_(static_cast<std::size_t>(world.size()), false) {
  MPI_Comm_set_errhandler(world_, MPI_ERRORS_RETURN);
  leave_signals_to_the_program();
  box_.send({world_.rank(), Packed().add(world_.size()).text()});
}

int PostOffice::carry() {
  const bool is_first = world_.rank() == 0;
  while (!(is_first ? program_has_ended_ : program_has_ended_ && is_told_to_end_)) {
    wait_for_the_program();
    take_from_program();
    take_from_ranks();
    drop_what_has_gone();
    look_at_the_program();
    beat();
    lose_the_silent();
  }
  if (is_first) end_all();
  if (first_is_lost_) return exit_file;
  return is_first ? exit_code() : exit_done;
}

/// Until it has something to send, or it is time to look for what MPI has.
void PostOffice::wait_for_the_program() {
  const auto idle = std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - last_traffic_);
  const auto look = std::clamp(
      std::chrono::nanoseconds(static_cast<long long>(share_of_idle_time * static_cast<double>(idle.count()))),
      std::chrono::nanoseconds(shortest_look), std::chrono::nanoseconds(longest_look));
  const timespec longest{0, static_cast<long>(look.count())};
  pollfd news{program_has_ended_ || box_.is_closed() ? -1 : box_.socket(), POLLIN, 0};
  ppoll(&news, 1, &longest, nullptr);
}

void PostOffice::take_from_program() {
  while (auto from_program = box_.take()) {
    last_traffic_ = Clock::now();
    send(from_program->who, Tag::letter, std::move(from_program->text));
  }
}

void PostOffice::take_from_ranks() {
  while (const auto there = world_.iprobe()) {
    std::string bytes(static_cast<std::size_t>(there->count<char>().value_or(0)), '\0');
    world_.recv(there->source(), there->tag(), bytes.data(), static_cast<int>(bytes.size()));
    last_heard_[static_cast<std::size_t>(there->source())] = Clock::now();
    if (there->tag() == Tag::end) end_the_program(bytes.empty());
    if (there->tag() != Tag::letter || program_has_ended_) continue;
    last_traffic_ = Clock::now();
    box_.send_without_waiting({there->source(), std::move(bytes)});
  }
  box_.send_rest_without_waiting();
}

/// A rank that is lost gets nothing.
void PostOffice::send(int rank, int tag, std::string bytes) {
  if (rank < 0 || rank >= world_.size() || is_lost_[static_cast<std::size_t>(rank)]) return;
  sendings_.push_back({std::move(bytes), {}});
  Sending& sending = sendings_.back();
  try {
    sending.request = world_.isend(rank, tag, sending.bytes.data(), static_cast<int>(sending.bytes.size()));
  } catch (const boost::mpi::exception&) {
    sendings_.pop_back();  // its silence will be noticed
  }
}

void PostOffice::drop_what_has_gone() {
  for (auto sending = sendings_.begin(); sending != sendings_.end();) {
    bool has_gone = true;
    try {
      has_gone = sending->request.test().has_value();
    } catch (const boost::mpi::exception&) {
    }
    sending = has_gone ? sendings_.erase(sending) : std::next(sending);
  }
}

void PostOffice::beat() {
  if (Clock::now() - last_beat_ < between_beats) return;
  last_beat_ = Clock::now();
  if (world_.rank() != 0) return send(0, Tag::heartbeat, "");
  for (int rank = 1; rank < world_.size(); ++rank) send(rank, Tag::heartbeat, "");
}

void PostOffice::lose_the_silent() {
  if (world_.rank() != 0) {
    if (!is_told_to_end_ && Clock::now() - last_heard_.front() > longest_silence) end_without_the_first();
    return;
  }
  for (std::size_t rank = 1; rank < last_heard_.size(); ++rank) {
    if (!is_lost_[rank] && Clock::now() - last_heard_[rank] > longest_silence) lose(rank);
  }
}

void PostOffice::lose(std::size_t rank) {
  is_lost_[rank] = true, all_are_here_ = false;
  box_.send_without_waiting({static_cast<int>(rank), ""});
}

void PostOffice::end_the_program(bool all_are_here) {
  is_told_to_end_ = true, all_are_here_ = all_are_here;
  ::shutdown(box_.socket(), SHUT_RDWR);  // for the program to see
}

void PostOffice::end_without_the_first() {
  first_is_lost_ = true;
  const std::string text =
      fmt::format("tether: the first program of this command is lost, says number {} on {}; the same command goes on\n",
                  world_.rank(), host_name());
  std::fputs(text.c_str(), stderr);
  end_the_program(false);
}

/// The program of a rank that ends by itself has crashed: rank 0 deals its run to another.
void PostOffice::look_at_the_program() {
  if (program_has_ended_ || waitpid(served_, &status_, WNOHANG) != served_) return;
  program_has_ended_ = true;
  take_from_program();  // what it has sent at its end
  if (world_.rank() != 0 && !is_told_to_end_) send(0, Tag::letter, "");
}

void PostOffice::end_all() {
  const std::string why = all_are_here_ ? "" : "some are lost";
  for (int rank = 1; rank < world_.size(); ++rank) send(rank, Tag::end, why);
  const auto start = Clock::now();
  while (!sendings_.empty() && Clock::now() - start < longest_silence) {
    take_from_ranks();
    drop_what_has_gone();
    usleep(1000);
  }
}

int PostOffice::exit_code() const {
  return WIFSIGNALED(status_) ? exit_signal + WTERMSIG(status_) : WEXITSTATUS(status_);
}

}  // namespace tether
