// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/result_folder.hpp"

#include <fmt/format.h>

#include <array>
#include <system_error>

#include "base/errors.hpp"
#include "base/file.hpp"
#include "base/version.hpp"
#include "results/text_writers.hpp"

namespace tether {
namespace {

constexpr std::array owned{"history.nc",  "history.txt",  "particles.nc",      "particles.xmf",
                           "mesh.nc",     "mesh.xmf",     "particles.xmf.new", "mesh.xmf.new",
                           "summary.txt", "messages.txt", "deck.effective",    "reference.txt"};

std::filesystem::path prepared(const std::filesystem::path& folder) {
  std::error_code reason;
  std::filesystem::create_directories(folder, reason);
  if (reason) throw FileError(fmt::format("{}: the folder cannot be made: {}", folder.string(), reason.message()));
  for (const char* name : owned) {
    std::filesystem::remove(folder / name, reason);
    if (reason) {
      throw FileError(
          fmt::format("{}: an earlier run's file cannot be removed: {}", (folder / name).string(), reason.message()));
    }
  }
  return folder;
}

}  // namespace

ResultFolder::ResultFolder(const std::filesystem::path& folder, const HistoryLayout& layout,
                           const Provenance& provenance)
    : folder_(prepared(folder)),
      command_(provenance.command),
      history_(folder_, layout, provenance),
      points_(folder_, provenance),
      grid_(folder_, provenance),
      messages_(folder_ / "messages.txt") {}

void ResultFolder::append(const Record& record) { history_.append(record); }

void ResultFolder::points(const Snapshot& snapshot) { points_.append(snapshot); }

void ResultFolder::grid(const BackgroundGrid& grid, const Snapshot& snapshot) { grid_.append(grid, snapshot); }

void ResultFolder::message(const std::string& text) {
  const bool ended = !text.empty() && text.back() == '\n';
  messages_.append(ended ? text : text + '\n');
}

void ResultFolder::deck_effective(const std::string& text) { write_file(folder_ / "deck.effective", text); }

void ResultFolder::reference(const Table& table) { write_table(folder_ / "reference.txt", table); }

void ResultFolder::finish(const Summary& summary) {
  history_.close();
  points_.close();
  grid_.close();
  write_summary(folder_ / "summary.txt", summary,
                {fmt::format("tether {} {}", program_version(), git_hash()), command_});
}

}  // namespace tether
