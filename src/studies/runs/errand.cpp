// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/runs/errand.hpp"

#include <fmt/format.h>

#include "base/diagnostics.hpp"
#include "base/letters.hpp"

namespace tether {
namespace {

std::string errand(ErrandKind kind, long long number, const std::string& text) {
  return Packed().add(std::string(word_of(kind))).add(static_cast<double>(number)).add(text).text();
}

}  // namespace

Errand::Errand(const std::string& letter) {
  Packed parts(letter);
  const auto kind = find_word<ErrandKind>(parts.take_text());
  if (!kind) throw FileError("a message from another program of this command is none that this one knows");
  kind_ = *kind;
  number_ = static_cast<long long>(parts.take_number());
  text_ = parts.take_text();
}

std::string Errand::of_hello(const std::string& program) { return errand(ErrandKind::hello, -1, program); }

std::string Errand::of_run(long long number, const RunTask& task) {
  return errand(ErrandKind::run, number, text_of(task));
}

std::string Errand::of_signal(long long number, int signal) {
  return errand(ErrandKind::signal, number, fmt::format("{}", signal));
}

std::string Errand::of_done(long long number, const RunRecord& record) {
  return errand(ErrandKind::done, number, text_of(record));
}

std::string Errand::of_blind(long long number, const std::string& message) {
  return errand(ErrandKind::blind, number, message);
}

}  // namespace tether
