// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/netcdf_input.hpp"

#include <fmt/format.h>
#include <netcdf.h>

#include <array>
#include <functional>
#include <numeric>

#include "base/errors.hpp"
#include "base/file.hpp"

namespace tether {

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
