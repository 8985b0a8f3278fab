// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/letters.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>

#include "base/diagnostics.hpp"
#include "base/numbers.hpp"

namespace tether {
namespace {

/// Stands before the text of a letter in a stream.
struct Heading {
  std::int64_t who = 0;
  std::uint64_t bytes = 0;
};

std::string bytes_of(const Letter& letter) {
  const Heading heading{letter.who, letter.text.size()};
  std::string bytes(sizeof heading, '\0');
  std::memcpy(bytes.data(), &heading, sizeof heading);
  return bytes + letter.text;
}

[[noreturn]] void refuse() { throw FileError("a message from another program of this command is cut short"); }

}  // namespace

LetterBox::~LetterBox() { ::close(socket_); }

void LetterBox::send(const Letter& letter) {
  const std::string bytes = bytes_of(letter);
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t count = ::send(socket_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      closed_ = true;
      return;
    }
    sent += static_cast<std::size_t>(count);
  }
}

bool LetterBox::send_without_waiting(const Letter& letter) {
  rest_ += bytes_of(letter);
  return send_rest_without_waiting();
}

bool LetterBox::send_rest_without_waiting() {
  while (!rest_.empty() && !closed_) {
    const ssize_t count = ::send(socket_, rest_.data(), rest_.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return false;
    if (count < 0) closed_ = true;
    if (count > 0) rest_.erase(0, static_cast<std::size_t>(count));
  }
  return true;
}

std::optional<Letter> LetterBox::take() {
  read_what_has_come();
  Heading heading;
  if (came_.size() < sizeof heading) return std::nullopt;
  std::memcpy(&heading, came_.data(), sizeof heading);
  if (came_.size() - sizeof heading < heading.bytes) return std::nullopt;
  Letter letter{static_cast<int>(heading.who), came_.substr(sizeof heading, heading.bytes)};
  came_.erase(0, sizeof heading + heading.bytes);
  return letter;
}

std::optional<Letter> LetterBox::wait() {
  for (;;) {
    auto letter = take();
    if (letter || closed_) return letter;
    pollfd news{socket_, POLLIN, 0};
    ::poll(&news, 1, -1);
  }
}

void LetterBox::read_what_has_come() {
  std::array<char, 65536> part{};
  while (!closed_) {
    const ssize_t count = ::recv(socket_, part.data(), part.size(), MSG_DONTWAIT);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return;
    if (count <= 0) closed_ = true;
    if (count > 0) came_.append(part.data(), static_cast<std::size_t>(count));
  }
}

Packed& Packed::add(const std::string& part) {
  text_ += fmt::format("{}:{}", part.size(), part);
  return *this;
}

Packed& Packed::add(double number) { return add(fmt::format("{}", number)); }

Packed& Packed::add(const std::vector<std::string>& parts) {
  add(static_cast<double>(parts.size()));
  for (const std::string& part : parts) add(part);
  return *this;
}

std::string Packed::take_text() {
  const std::size_t colon = text_.find(':', at_);
  if (colon == std::string::npos) refuse();
  const auto bytes = parse_integer(std::string_view(text_).substr(at_, colon - at_));
  if (!bytes || *bytes < 0 || static_cast<std::size_t>(*bytes) > text_.size() - colon - 1) refuse();
  at_ = colon + 1 + static_cast<std::size_t>(*bytes);
  return text_.substr(colon + 1, static_cast<std::size_t>(*bytes));
}

double Packed::take_number() {
  const auto number = parse_real(take_text());
  if (!number) refuse();
  return *number;
}

std::vector<std::string> Packed::take_texts() {
  std::vector<std::string> parts(static_cast<std::size_t>(take_number()));
  for (std::string& part : parts) part = take_text();
  return parts;
}

}  // namespace tether
