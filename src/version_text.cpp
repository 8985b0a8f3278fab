// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <netcdf.h>
#include <openssl/crypto.h>

#include <CLI/Version.hpp>
#include <boost/version.hpp>

#include "base/version.hpp"
#include "commands.hpp"

namespace tether {

std::string version_text() {
  return fmt::format("tether {} ({})\nnetcdf {}\nfmt {}.{}.{}\nCLI11 {}\nBoost {}.{}\n{}", program_version(),
                     git_hash(), nc_inq_libvers(), FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100,
                     CLI11_VERSION, BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000,
                     OpenSSL_version(OPENSSL_VERSION));
}

}  // namespace tether
