// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <netcdf.h>
#include <openssl/crypto.h>

#include <CLI/Version.hpp>
#include <boost/version.hpp>

#include "base/version.hpp"
#include "commands.hpp"

namespace tether {
namespace {

/// "4.9.0": what stands before the date of its build.
std::string netcdf_version() {
  const std::string text = nc_inq_libvers();
  return text.substr(0, text.find(' '));
}

}  // namespace

std::string version_text() {
  return fmt::format("tether {} ({})\nnetcdf {}\nfmt {}.{}.{}\nCLI11 {}\nBoost {}.{}\n{}", program_version(),
                     git_hash(), netcdf_version(), FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100,
                     CLI11_VERSION, BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000,
                     OpenSSL_version(OPENSSL_VERSION));
}

}  // namespace tether
