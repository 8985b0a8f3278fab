// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/gmsh/file.hpp"

#include <fmt/format.h>
#include <algorithm>

#include "base/text.hpp"
#include "grid/gmsh/mesh.hpp"
#include "grid/gmsh/versions.hpp"

namespace tether {
namespace {

using namespace gmsh;

constexpr const char* how_to_save = "Save with: gmsh -save -format msh41 MODEL, or msh22.";

/// Returns 22, 41, or nothing, which is reported: version, 0 of an ASCII file, size of its numbers.
std::optional<int> version_of(const File& file) {
  auto format = file.section("MeshFormat");
  if (!format) {
    file.remarks.error(0, 0, "no section $MeshFormat: this is no mesh file of Gmsh", how_to_save);
    return std::nullopt;
  }
  auto words = format->next("the version of the format");
  const auto version = words ? words->real("the version") : std::nullopt;
  if (!version) return std::nullopt;
  if (*version != 2.2 && *version != 4.1) {
    words->error(fmt::format("version {:.6g} of the format is not read", *version), how_to_save);
    return std::nullopt;
  }
  if (!words->whole("the type of the file", 0, 1)) return std::nullopt;
  return *version == 2.2 ? 22 : 41;
}

/// dimension tag "name"
void read_group(Words words, std::vector<Group>& groups) {
  const auto dim = words.whole("the dimension of a group", 0, 3);
  const auto tag = dim ? words.whole("the tag of a group", 1, largest_tag) : std::nullopt;
  const auto name = tag ? words.quoted("the name of a group") : std::nullopt;
  if (!name || !words.done("A group is: dimension tag \"name\".")) return;
  for (const Group& other : groups) {
    if (other.dim != *dim || (other.tag != *tag && other.name != *name)) continue;
    return words.error(fmt::format("a group of dimension {} has this {} already, at line {}", *dim,
                                   other.tag == *tag ? "tag" : "name", other.line));
  }
  groups.push_back({static_cast<int>(*dim), static_cast<int>(*tag), *name, words.line()});
}

void read_groups(const File& file, Content& content) {
  auto reader = file.section("PhysicalNames");
  if (!reader) return;
  auto header = reader->next("the number of groups");
  const auto count = header ? header->whole("the number of groups", 0, largest_number) : std::nullopt;
  if (!count || !reader->bears_out(*header, *count, "groups")) return;
  for (long long k = 0; k < *count; ++k) {
    auto line = reader->next(fmt::format("group {} of {}", k + 1, *count));
    if (!line) return;
    read_group(*line, content.groups);
  }
  reader->expect_end("groups");
}

/// Nodes and elements must be there.
void check_sections(const File& file) {
  for (const char* name : {"Nodes", "Elements"}) {
    if (file.sections.count(name) == 0)
      file.remarks.error(0, 0, fmt::format("there is no section ${}", name), "Is the file cut off?");
  }
}

/// Reports a binary file, whose sections are no lines: what reading them would report is rubbish.
bool is_binary(const std::vector<std::string>& lines, Remarks& remarks) {
  const auto format =
      std::find_if(lines.begin(), lines.end(), [](const auto& line) { return trim(line) == "$MeshFormat"; });
  if (format == lines.end() || format + 1 == lines.end()) return false;
  const int number = static_cast<int>(format - lines.begin()) + 2;
  Diagnostics ignored;
  Remarks nobody("", lines, 1, ignored);
  Words words(*(format + 1), number, nobody);
  const auto version = words.real("the version");
  const auto type = version ? words.whole("the type of the file", 0, 1) : std::nullopt;
  if (type.value_or(0) == 0) return false;
  remarks.error(
      number, static_cast<int>(words.place()) + 1, "this is a binary file",
      fmt::format("{} (without -bin); 'gmsh FILE -0 -o ascii.msh -format msh41' makes one of it", how_to_save));
  return true;
}

std::vector<Mesh> meshes_of_lines(const std::vector<std::string>& lines, const std::vector<FileRegion>& regions,
                                  std::vector<MeshFlaw>& flaws, Remarks& remarks) {
  if (is_binary(lines, remarks)) return {};
  std::map<std::string, Section> sections;
  {
    // Of a file in another format, only that is reported.
    const auto first = std::find_if(lines.begin(), lines.end(), [](const auto& line) { return !trim(line).empty(); });
    if (first != lines.end() && first->starts_with('*')) {
      remarks.error(static_cast<int>(first - lines.begin()) + 1, 1, "this looks like a mesh of CalculiX or Abaqus",
                    "/usr/bin/python3 post/inp.py FILE.inp makes a mesh file of it");
      return {};
    }
    const bool begins = first != lines.end() && (trim(*first) == "$MeshFormat" || trim(*first) == "$Comments");
    if (begins) sections = sections_of(lines, remarks);
  }
  const File file{lines, sections, remarks};
  const auto version = version_of(file);
  if (!version) return {};
  check_sections(file);
  Content content;
  read_groups(file, content);
  *version == 22 ? read_version_22(file, content) : read_version_41(file, content);
  if (remarks.has_errors()) return {};
  content.first_line = sections.at("Elements").line;
  return meshes_of_content(content, regions, flaws, remarks);
}

}  // namespace

std::vector<Mesh> read_gmsh_meshes(std::string_view text, const std::string& file,
                                   const std::vector<FileRegion>& regions, std::vector<MeshFlaw>& flaws,
                                   Diagnostics& diagnostics) {
  const std::vector<std::string> lines = split_lines(text);
  Remarks remarks(file, lines, 1, diagnostics);
  if (auto [message, hint] = no_text(text); !message.empty() && text.find("$MeshFormat") == std::string_view::npos) {
    remarks.error(0, 0, std::move(message), how_to_save);
    return {};
  }
  return meshes_of_lines(lines, regions, flaws, remarks);
}

std::optional<Mesh> read_gmsh(std::string_view text, const std::string& file, const std::vector<std::string>& groups,
                              std::vector<MeshFlaw>& flaws, Diagnostics& diagnostics) {
  std::vector<FileRegion> regions;
  for (const std::string& group : groups) regions.push_back({static_cast<int>(regions.size()) + 1, group, 0});
  std::vector<Mesh> meshes = read_gmsh_meshes(text, file, regions, flaws, diagnostics);
  return meshes.empty() ? std::nullopt : std::optional(std::move(meshes.front()));
}

}  // namespace tether
