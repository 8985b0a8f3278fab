// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tether {

/// A message between programs of one command that was started many times: to whom where it is sent, from whom where it
/// has come. Programs are numbered from 0.
struct Letter {
  int who = 0;
  std::string text;
};

/// One end of a pair of stream sockets that carries letters. The end is open as long as this lives.
class LetterBox {
 public:
  explicit LetterBox(int socket) : socket_(socket) {}
  ~LetterBox();
  LetterBox(const LetterBox&) = delete;
  LetterBox& operator=(const LetterBox&) = delete;

  /// The socket, for those who wait until something comes.
  int socket() const { return socket_; }
  /// Sends the whole letter, waits as long as that takes. Nothing where nobody is at the other end.
  void send(const Letter& letter);
  /// Sends as much as the other end takes without waiting; keeps the rest. Returns whether all has gone.
  bool send_without_waiting(const Letter& letter);
  bool send_rest_without_waiting();
  /// The next letter that has come whole; none where there is none yet. Does not wait.
  std::optional<Letter> take();
  /// The next letter, however long it takes until it has come; none where the other end is closed.
  std::optional<Letter> wait();
  /// Returns whether the other end is closed; letters that came before can still be taken.
  bool is_closed() const { return closed_; }

 private:
  void read_what_has_come();

  int socket_;
  std::string came_, rest_;
  bool closed_ = false;
};

/// Texts and numbers as one text, from which they are taken in their order.
class Packed {
 public:
  Packed() = default;
  explicit Packed(std::string text) : text_(std::move(text)) {}

  Packed& add(const std::string& part);
  Packed& add(double number);
  Packed& add(const std::vector<std::string>& parts);
  const std::string& text() const { return text_; }

  /// Each of them throws FileError where there is no such part.
  std::string take_text();
  double take_number();
  std::vector<std::string> take_texts();

 private:
  std::string text_;
  std::size_t at_ = 0;
};

}  // namespace tether
