// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/checkpoint.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <map>
#include <sstream>
#include <system_error>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "results/netcdf_file.hpp"
#include "results/seal.hpp"

namespace tether {
namespace {

const std::string state_prefix = "state_";

/// Of the variables and attributes below: another one is another file.
const std::string format = "2";

std::vector<double> flat(const std::vector<Record>& records) {
  std::vector<double> numbers;
  for (const auto& record : records) numbers.insert(numbers.end(), record.begin(), record.end());
  return numbers;
}

std::vector<double> flat(const std::vector<SavedDue>& dues) {
  std::vector<double> numbers;
  for (const auto& due : dues) numbers.insert(numbers.end(), {due.interval, due.next});
  return numbers;
}

/// Bytes of all numbers and of the header, at most.
std::size_t room_of(const Checkpoint& checkpoint) {
  constexpr std::size_t definition = 256, rest = 4096;
  std::size_t room = provenance_room(checkpoint.provenance) + checkpoint.deck_effective.size() + rest;
  for (const auto& message : checkpoint.messages) room += message.size() + 1;
  for (const auto& [name, array] : checkpoint.state) room += array.size() * sizeof(double) + definition;
  return room + checkpoint.records.size() * checkpoint.records.front().size() * sizeof(double);
}

/// A variable to be put once all are defined.
struct Pending {
  int variable;
  std::vector<std::size_t> shape;
  const std::vector<double>* numbers;
};

/// A part a line: name, seconds of the processor, seconds of the clock on the wall.
std::string text_of(const std::vector<CostPart>& parts) {
  std::string text;
  for (const auto& [name, taken] : parts) text += fmt::format("{} {} {}\n", name, taken.cpu, taken.wall);
  return text;
}

/// The whole and the set-up come first.
std::vector<CostPart> seconds_of(const Checkpoint& checkpoint) {
  std::vector<CostPart> parts{{"whole", checkpoint.whole}, {"setup", checkpoint.setup}};
  parts.insert(parts.end(), checkpoint.parts.begin(), checkpoint.parts.end());
  return parts;
}

void read_seconds(const std::string& text, Checkpoint& checkpoint) {
  std::istringstream words(text);
  CostPart part;
  while (words >> part.name >> part.taken.cpu >> part.taken.wall) {
    if (part.name == "whole")
      checkpoint.whole = part.taken;
    else if (part.name == "setup")
      checkpoint.setup = part.taken;
    else
      checkpoint.parts.push_back(part);
  }
}

class Writer {
 public:
  explicit Writer(const std::filesystem::path& path, std::size_t room) : file_(path, NetcdfFormat::offset64, room) {
    define_seal(file_);
  }

  void attributes(const Checkpoint& checkpoint) {
    write_provenance(file_, checkpoint.provenance);
    file_.global_attribute("checkpoint_format", format);
    file_.global_attribute("deck_effective", checkpoint.deck_effective);
    file_.global_attribute("messages", fmt::format("{}", fmt::join(checkpoint.messages, "\n")));
    file_.global_attribute("seconds", text_of(seconds_of(checkpoint)));
  }
  void define(const std::string& name, const std::vector<double>& numbers, std::vector<std::size_t> shape) {
    std::vector<int> dimensions;
    dimensions.reserve(shape.size());
    for (const std::size_t length : shape) dimensions.push_back(dimension(length));
    pending_.push_back({file_.number_variable(name, dimensions), std::move(shape), &numbers});
  }
  void put_all() {
    file_.end_definitions();
    for (const Pending& p : pending_)
      file_.put(p.variable, {std::vector<std::size_t>(p.shape.size(), 0), p.shape}, *p.numbers);
    file_.close();
  }

 private:
  /// One dimension a length, shared by all arrays of it.
  int dimension(std::size_t length) {
    const auto [found, fresh] = dimensions_.try_emplace(length, -1);
    if (fresh) found->second = file_.dimension(fmt::format("of_{}", length), length);
    return found->second;
  }
  NetcdfFile file_;
  std::map<std::size_t, int> dimensions_;
  std::vector<Pending> pending_;
};

void write(const std::filesystem::path& path, const Checkpoint& checkpoint) {
  const auto history = flat(checkpoint.records), dues = flat(checkpoint.dues);
  std::vector<double> run{checkpoint.time, static_cast<double>(checkpoint.point_snapshots),
                          static_cast<double>(checkpoint.grid_snapshots)};
  run.insert(run.end(), checkpoint.watched.begin(), checkpoint.watched.end());
  Writer writer(path, room_of(checkpoint));
  writer.attributes(checkpoint);
  for (const auto& [name, array] : checkpoint.state) writer.define(state_prefix + name, array, {array.size()});
  writer.define("history", history, {checkpoint.records.size(), checkpoint.records.front().size()});
  writer.define("dues", dues, {checkpoint.dues.size(), 2});
  writer.define("run", run, {run.size()});
  writer.put_all();
}

SavedState read_state(const NetcdfInput& file) {
  SavedState state;
  for (const auto& name : file.variables()) {
    if (name.starts_with(state_prefix)) state[name.substr(state_prefix.size())] = file.numbers(name);
  }
  return state;
}

std::vector<Record> read_records(const NetcdfInput& file) {
  const auto shape = file.shape("history");
  std::vector<Record> records;
  for (std::size_t k = 0; k < shape[0]; ++k) records.push_back(file.numbers("history", {{k, 0}, {1, shape[1]}}));
  return records;
}

std::vector<SavedDue> read_dues(const NetcdfInput& file) {
  const auto numbers = file.numbers("dues");
  std::vector<SavedDue> dues;
  for (std::size_t k = 0; k + 1 < numbers.size(); k += 2) dues.push_back({numbers[k], numbers[k + 1]});
  return dues;
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint) {
  replace_whole(path, Reach::disk, [&checkpoint](const std::filesystem::path& fresh) {
    write(fresh, checkpoint);
    seal(fresh);
  });
}

std::string this_program() { return fmt::format("tether {} {}", program_version(), git_hash()); }

Checkpoint read_checkpoint(const std::filesystem::path& path) {
  const std::string broken = broken_seal(path);
  if (!broken.empty()) throw FileError(fmt::format("{}: {}", path.string(), broken));
  const NetcdfInput file(path);
  if (file.global_attribute("checkpoint_format") != format) {
    throw FileError(fmt::format("{}: another version of the program wrote it, {}", path.string(),
                                file.global_attribute("program")));
  }
  Checkpoint checkpoint;
  checkpoint.provenance.title = file.global_attribute("title");
  checkpoint.written_by = file.global_attribute("program") + " " + file.global_attribute("git_hash");
  checkpoint.deck_effective = file.global_attribute("deck_effective");
  checkpoint.state = read_state(file);
  checkpoint.records = read_records(file);
  checkpoint.dues = read_dues(file);
  checkpoint.messages = split_lines(file.global_attribute("messages"));
  read_seconds(file.global_attribute("seconds"), checkpoint);
  const auto run = file.numbers("run");
  checkpoint.time = run.at(0);
  checkpoint.point_snapshots = static_cast<std::size_t>(run.at(1));
  checkpoint.grid_snapshots = static_cast<std::size_t>(run.at(2));
  checkpoint.watched.assign(run.begin() + 3, run.end());
  return checkpoint;
}

namespace {

constexpr std::size_t kept = 2;
const std::string prefix = "checkpoint-", suffix = ".nc";

/// N of checkpoint-N.nc; 0 for any other name.
unsigned long long number_of(const std::string& name) {
  if (!name.starts_with(prefix) || !name.ends_with(suffix)) return 0;
  const std::string digits = name.substr(prefix.size(), name.size() - prefix.size() - suffix.size());
  const bool number =
      !digits.empty() && digits.size() < 19 && digits.find_first_not_of("0123456789") == std::string::npos;
  return number ? std::stoull(digits) : 0;
}

unsigned long long number_of(const std::filesystem::path& path) { return number_of(path.filename().string()); }

void remove_older(const std::vector<std::filesystem::path>& newest_first) {
  for (std::size_t k = kept; k < newest_first.size(); ++k) remove_checkpoint(newest_first[k]);
}

}  // namespace

void remove_checkpoint(const std::filesystem::path& path) {
  std::error_code reason;
  std::filesystem::remove(path, reason);
  if (reason) throw FileError(fmt::format("{}: cannot be removed: {}", path.string(), reason.message()));
}

std::vector<std::filesystem::path> checkpoints_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> found;
  std::error_code reason;  // of a folder that is not there: nothing is in it
  for (const auto& entry : std::filesystem::directory_iterator(folder, reason)) {
    if (number_of(entry.path()) > 0) found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return number_of(a) > number_of(b); });
  return found;
}

std::filesystem::path newest_checkpoint(const std::filesystem::path& folder, const std::string& deck_effective) {
  for (const auto& path : checkpoints_in(folder)) {
    try {
      if (read_checkpoint(path).deck_effective == deck_effective) return path;
    } catch (const FileError&) {
      continue;  // damaged: an older one will do, or the start
    }
  }
  return {};
}

std::filesystem::path add_checkpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint) {
  const auto before = checkpoints_in(folder);
  const auto number = before.empty() ? 1 : number_of(before.front()) + 1;
  auto path = folder / fmt::format("{}{}{}", prefix, number, suffix);
  write_checkpoint(path, checkpoint);
  remove_older(checkpoints_in(folder));
  return path;
}

}  // namespace tether
