// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <netcdf.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "grid/boxes.hpp"
#include "results/results.hpp"
#include "unit/temporary_folder.hpp"

namespace tether::test {

/// A NetCDF file opened with the bare C interface, apart from the code under test.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& path) { check(nc_open(path.c_str(), NC_NOWRITE | NC_SHARE, &id_)); }
  ~Reader() { nc_close(id_); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  void refresh() { check(nc_sync(id_)); }
  int format() const {
    int format = 0;
    check(nc_inq_format(id_, &format));
    return format;
  }
  bool has(const std::string& name) const {
    int variable = 0;
    return nc_inq_varid(id_, name.c_str(), &variable) == NC_NOERR;
  }
  std::size_t length(const std::string& dimension) const {
    int d = 0;
    std::size_t n = 0;
    check(nc_inq_dimid(id_, dimension.c_str(), &d));
    check(nc_inq_dimlen(id_, d, &n));
    return n;
  }
  bool unlimited(const std::string& dimension) const {
    int d = 0, u = -1;
    check(nc_inq_dimid(id_, dimension.c_str(), &d));
    check(nc_inq_unlimdim(id_, &u));
    return d == u;
  }
  std::vector<std::string> dimensions(const std::string& name) const {
    int n = 0;
    check(nc_inq_varndims(id_, variable(name), &n));
    std::vector<int> ids(static_cast<std::size_t>(n));
    check(nc_inq_vardimid(id_, variable(name), ids.data()));
    std::vector<std::string> names;
    for (const int d : ids) {
      char text[NC_MAX_NAME + 1];
      check(nc_inq_dimname(id_, d, text));
      names.emplace_back(text);
    }
    return names;
  }
  std::vector<double> values(const std::string& name) const {
    std::vector<double> all(size(name));
    check(nc_get_var_double(id_, variable(name), all.data()));
    return all;
  }
  std::string text(const std::string& name) const {
    std::string all(size(name), ' ');
    check(nc_get_var_text(id_, variable(name), all.data()));
    return all;
  }
  std::string attribute(const std::string& name, const std::string& of = {}) const {
    const int v = of.empty() ? NC_GLOBAL : variable(of);
    std::size_t n = 0;
    check(nc_inq_attlen(id_, v, name.c_str(), &n));
    std::string all(n, ' ');
    check(nc_get_att_text(id_, v, name.c_str(), all.data()));
    return all;
  }
  /// Of a whole number; another type is an error.
  int whole_attribute(const std::string& name, const std::string& of) const {
    nc_type type = NC_NAT;
    int number = 0;
    check(nc_inq_atttype(id_, variable(of), name.c_str(), &type));
    if (type != NC_INT) throw std::runtime_error(name + " is no whole number");
    check(nc_get_att_int(id_, variable(of), name.c_str(), &number));
    return number;
  }

 private:
  static void check(int status) {
    if (status != NC_NOERR) throw std::runtime_error(nc_strerror(status));
  }
  int variable(const std::string& name) const {
    int v = 0;
    check(nc_inq_varid(id_, name.c_str(), &v));
    return v;
  }
  std::size_t size(const std::string& name) const {
    std::size_t n = 1;
    for (const auto& d : dimensions(name)) n *= length(d);
    return n;
  }
  int id_ = -1;
};

inline Provenance provenance() {
  return {"Sod's tube\nsecond line", "tether decks/sod.in", "$in tmax=0.2 $end\n", "5f70bf18", Units::si, "run 1"};
}

/// time, one quantity of the scene, one of two bodies, one of three points.
inline HistoryLayout small_layout() {
  return {{{"time", Dimension::time, "time"},
           {"energy_total", Dimension::energy, "energy of the scene"},
           {"body_x", Dimension::length, "x of a body's centre of mass", Per::body},
           {"point_vy", Dimension::velocity, "velocity of a point along y", Per::point}},
          {"gas", "the bag"},
          {"apex", "left end", "p"}};
}

/// Fields x, y, id and pressure of three points, all different in each record.
inline Snapshot three_points(double time) {
  return {time,
          {{{"x", Dimension::length, "place along x"}, {0.5 + time, 1.5, 2.5}},
           {{"y", Dimension::length, "place along y"}, {-1.0, 0.1 * time, 1.0 / 3}},
           {{"id", Dimension::number, "number of the point"}, {1, 2, 3}},
           {{"pressure", Dimension::stress, "pressure"}, {1e5, 2e5 + time, -3e-300}}}};
}

/// 3 x 2 nodes from (-1, 10).
inline BackgroundGrid small_grid() { return {3, 2, -1.0, 0.0, 10.0, 10.25}; }

inline Snapshot six_nodes(double time) {
  return {time, {{{"grid_mass", Dimension::mass, "mass of a node"}, {time, 1, 2, 10, 11, 12}}}};
}

}  // namespace tether::test
