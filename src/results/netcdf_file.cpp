// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/netcdf_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <netcdf.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <cstring>
#include <functional>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <system_error>

#include "base/diagnostics.hpp"
#include "base/file.hpp"
#include "base/process.hpp"

namespace tether {
namespace {

/// The library would read past the end of too few values.
void check_size(const NetcdfFile::Part& part, std::size_t given) {
  const auto wanted = std::accumulate(part.count.begin(), part.count.end(), std::size_t{1}, std::multiplies<>());
  if (given != wanted) throw std::invalid_argument(fmt::format("{} values for a part of {}", given, wanted));
}

/// Claims room in a file; `mode` may have it created or emptied first.
void claim(const std::filesystem::path& path, int mode, std::size_t bytes) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | mode, 0666);
  if (file < 0) throw FileError(fmt::format("{}: cannot open the file: {}", path.string(), std::strerror(errno)));
  const int reason = claim_room(file, bytes);
  ::close(file);
  if (reason != 0) {
    throw FileError(
        fmt::format("{}: cannot get room for {} more bytes: {}", path.string(), bytes, std::strerror(reason)));
  }
}

/// Finds out whether there is room for a new file, and leaves none where there is not: an empty file would only pass
/// for a damaged one.
void claim_new(const std::filesystem::path& path, std::size_t bytes) {
  try {
    claim(path, O_CREAT | O_TRUNC, bytes);
  } catch (const FileError&) {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
    throw;
  }
}

}  // namespace

NetcdfFile::NetcdfFile(std::filesystem::path path, NetcdfFormat format, std::size_t room) : path_(std::move(path)) {
  if (room > 0) claim_new(path_, room);
  const int mode = format == NetcdfFormat::offset64 ? NC_64BIT_OFFSET : NC_NETCDF4;
  check(nc_create(path_.c_str(), NC_CLOBBER | mode, &id_), "create the file");
  open_ = true;
  int before = 0;
  const int status = nc_set_fill(id_, NC_NOFILL, &before);
  if (status != NC_NOERR) nc_close(id_);  // the destructor of a half-made object does not run
  check(status, "turn filling off");
}

NetcdfFile::~NetcdfFile() {
  if (open_) nc_close(id_);
}

int NetcdfFile::dimension(const std::string& name, std::size_t length) {
  int dimension = -1;
  check(nc_def_dim(id_, name.c_str(), length == unlimited ? NC_UNLIMITED : length, &dimension),
        fmt::format("define dimension {}", name));
  return dimension;
}

int NetcdfFile::number_variable(const std::string& name, const std::vector<int>& dimensions) {
  return define(name, NC_DOUBLE, dimensions);
}

int NetcdfFile::integer_variable(const std::string& name, const std::vector<int>& dimensions) {
  return define(name, NC_INT, dimensions);
}

int NetcdfFile::text_variable(const std::string& name, const std::vector<int>& dimensions) {
  return define(name, NC_CHAR, dimensions);
}

int NetcdfFile::define(const std::string& name, int type, const std::vector<int>& dimensions) {
  int variable = -1;
  check(nc_def_var(id_, name.c_str(), type, static_cast<int>(dimensions.size()), dimensions.data(), &variable),
        fmt::format("define variable {}", name));
  return variable;
}

void NetcdfFile::attribute(int variable, const std::string& name, std::string_view text) {
  check(nc_put_att_text(id_, variable, name.c_str(), text.size(), text.data()),
        fmt::format("write attribute {}", name));
}

void NetcdfFile::attribute(int variable, const std::string& name, int number) {
  check(nc_put_att_int(id_, variable, name.c_str(), NC_INT, 1, &number), fmt::format("write attribute {}", name));
}

void NetcdfFile::global_attribute(const std::string& name, std::string_view text) { attribute(NC_GLOBAL, name, text); }

void NetcdfFile::chunk(int variable, const std::vector<std::size_t>& lengths) {
  const auto name = variable_name(variable);
  check(nc_def_var_chunking(id_, variable, NC_CHUNKED, lengths.data()), fmt::format("set the chunks of {}", name));
  // Chunks are put whole and never read back: a cache would only hold memory. A size of 0 would mean the default of
  // 16 MB.
  check(nc_set_var_chunk_cache(id_, variable, 1, 1, 0), fmt::format("turn the cache of {} off", name));
}

void NetcdfFile::fill(int variable, bool of_integers) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const void* filling = of_integers ? static_cast<const void*>(&no_whole_number) : &nan;
  check(nc_def_var_fill(id_, variable, NC_FILL, filling), fmt::format("set what fills {}", variable_name(variable)));
}

void NetcdfFile::end_definitions() { check(nc_enddef(id_), "write the definitions"); }

void NetcdfFile::put(int variable, const Part& part, std::span<const double> values) {
  check_size(part, values.size());
  check(nc_put_vara_double(id_, variable, part.start.data(), part.count.data(), values.data()),
        fmt::format("write {}", variable_name(variable)));
}

void NetcdfFile::put_text(int variable, const Part& part, std::string_view text) {
  check_size(part, text.size());
  check(nc_put_vara_text(id_, variable, part.start.data(), part.count.data(), text.data()),
        fmt::format("write {}", variable_name(variable)));
}

void NetcdfFile::reserve(std::size_t bytes) const { claim(path_, 0, bytes); }

void NetcdfFile::sync() { check(nc_sync(id_), "write the file through to the disk"); }

void NetcdfFile::close() {
  open_ = false;  // whatever close answers, the identifier is gone
  check(nc_close(id_), "close the file");
}

std::string NetcdfFile::variable_name(int variable) const {
  std::array<char, NC_MAX_NAME + 1> name{};
  check(nc_inq_varname(id_, variable, name.data()), "look up a variable");
  return name.data();
}

void NetcdfFile::check(int status, std::string_view doing) const {
  if (status == NC_NOERR) return;
  throw FileError(fmt::format("{}: cannot {}: {}", path_.string(), doing, nc_strerror(status)));
}

void write_provenance(NetcdfFile& file, const Provenance& provenance) {
  file.global_attribute("Conventions", "CF-1.10");
  file.global_attribute("title", provenance.title);
  file.global_attribute("history", provenance.command);
  file.global_attribute("program", "tether " + program_version());
  file.global_attribute("git_hash", git_hash());
  file.global_attribute("deck", provenance.deck_text);
  file.global_attribute("deck_sha256", provenance.deck_sha256);
  file.global_attribute(run_attribute, provenance.run_sha256);
}

std::size_t provenance_room(const Provenance& provenance) {
  constexpr std::size_t names_and_versions = 4096;
  return provenance.title.size() + provenance.command.size() + provenance.deck_text.size() + names_and_versions;
}

int define_time(NetcdfFile& file, const Quantity& time, int dimension, Units units) {
  const int variable = define_quantity(file, time, {dimension}, units);
  file.attribute(variable, "axis", "T");
  if (units != Units::none) file.attribute(variable, "standard_name", "time");
  return variable;
}

int define_quantity(NetcdfFile& file, const Quantity& quantity, const std::vector<int>& dimensions, Units units) {
  const int variable = is_whole(quantity) ? file.integer_variable(quantity.name, dimensions)
                                          : file.number_variable(quantity.name, dimensions);
  file.attribute(variable, "units", unit_text(quantity.dimension, units));
  file.attribute(variable, "long_name", quantity.meaning);
  return variable;
}

NetcdfInput::NetcdfInput(std::filesystem::path path) : path_(std::move(path)) {
  refuse_irregular_file(path_);
  check(nc_open(path_.c_str(), NC_NOWRITE, &id_), "open the file");
}

NetcdfInput::~NetcdfInput() { nc_close(id_); }

std::string NetcdfInput::global_attribute(const std::string& name) const {
  const auto doing = fmt::format("read attribute {}", name);
  std::size_t length = 0;
  check(nc_inq_attlen(id_, NC_GLOBAL, name.c_str(), &length), doing);
  std::string text(length, '\0');
  check(nc_get_att_text(id_, NC_GLOBAL, name.c_str(), text.data()), doing);
  return text;
}

std::vector<std::string> NetcdfInput::variables() const {
  int count = 0;
  check(nc_inq_nvars(id_, &count), "count the variables");
  std::vector<std::string> names;
  for (int variable = 0; variable < count; ++variable) {
    std::array<char, NC_MAX_NAME + 1> name{};
    check(nc_inq_varname(id_, variable, name.data()), "look up a variable");
    names.emplace_back(name.data());
  }
  return names;
}

std::vector<std::size_t> NetcdfInput::shape(const std::string& variable) const {
  const int id = find(variable);
  const auto doing = fmt::format("read the shape of {}", variable);
  int count = 0;
  check(nc_inq_varndims(id_, id, &count), doing);
  std::vector<int> dimensions(static_cast<std::size_t>(count));
  check(nc_inq_vardimid(id_, id, dimensions.data()), doing);
  std::vector<std::size_t> lengths;
  for (const int dimension : dimensions) {
    lengths.push_back(0);
    check(nc_inq_dimlen(id_, dimension, &lengths.back()), doing);
  }
  return lengths;
}

std::vector<double> NetcdfInput::numbers(const std::string& variable) const {
  const auto lengths = shape(variable);
  return numbers(variable, {std::vector<std::size_t>(lengths.size(), 0), lengths});
}

std::vector<double> NetcdfInput::numbers(const std::string& variable, const NetcdfFile::Part& part) const {
  const int id = find(variable);
  std::vector<double> values(
      std::accumulate(part.count.begin(), part.count.end(), std::size_t{1}, std::multiplies<>()));
  check(nc_get_vara_double(id_, id, part.start.data(), part.count.data(), values.data()),
        fmt::format("read {}", variable));
  return values;
}

int NetcdfInput::find(const std::string& variable) const {
  int id = -1;
  check(nc_inq_varid(id_, variable.c_str(), &id), fmt::format("find variable {}", variable));
  return id;
}

void NetcdfInput::check(int status, std::string_view doing) const {
  if (status == NC_NOERR) return;
  throw FileError(fmt::format("{}: cannot {}: {}", path_.string(), doing, nc_strerror(status)));
}

}  // namespace tether
