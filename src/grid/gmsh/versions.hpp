// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/diagnostics.hpp"
#include "grid/gmsh/content.hpp"
#include "grid/gmsh/lines.hpp"

namespace tether::gmsh {

/// The lines of a file, and which of them are its sections.
struct File {
  const std::vector<std::string>& lines;
  const std::map<std::string, Section>& sections;
  Remarks& remarks;

  /// A reader of a section, or nothing where there is none.
  std::optional<Reader> section(const char* name) const {
    const auto found = sections.find(name);
    return found == sections.end() ? std::nullopt : std::optional(Reader(lines, found->second, remarks));
  }
};

/// Add nodes and elements as versions 2.2 and 4.1 write them, which differ in everything but the names of groups.
void read_version_22(const File& file, Content& content);
void read_version_41(const File& file, Content& content);

constexpr long long largest_number = 9'000'000'000'000'000'000;  ///< of a node, an element or a count
constexpr long long largest_tag = 2'000'000'000;                 ///< of a group or an entity

}  // namespace tether::gmsh
