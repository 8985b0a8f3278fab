# SPDX-License-Identifier: GPL-3.0-or-later
# generated/base/version_values.hpp: the program version and the git hash of the tree at build time.
add_custom_target(tether_version
  COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D VERSION=${PROJECT_VERSION}
          -D OUT=${PROJECT_BINARY_DIR}/generated/base/version_values.hpp -P ${PROJECT_SOURCE_DIR}/cmake/write_version.cmake
  BYPRODUCTS ${PROJECT_BINARY_DIR}/generated/base/version_values.hpp
  COMMENT "git hash")
