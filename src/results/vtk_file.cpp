// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/vtk_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/diagnostics.hpp"
#include "base/file.hpp"

namespace tether {
namespace {

constexpr std::string_view tail = "\n</AppendedData>\n</VTKFile>\n";
constexpr std::string_view axes = "xyz";

bool is_axis(char letter) { return axes.find(letter) != std::string_view::npos; }

/// "v" of vx, "force" of force_x.
std::string vector_name(std::string stem) {
  if (stem.ends_with('_')) stem.pop_back();
  return stem;
}

/// The text before the last letter, where that is an axis and the one before it is none.
bool may_be_component(const std::string& field) {
  return !field.empty() && is_axis(field.back()) && (field.size() == 1 || !is_axis(field[field.size() - 2]));
}

bool has(const std::vector<std::string>& fields, const std::string& name) {
  return std::find(fields.begin(), fields.end(), name) != fields.end();
}

std::uint64_t bytes_of(const VtkNumbers& numbers) {
  return std::visit([](const auto& values) { return values.size() * sizeof(values[0]); }, numbers.values);
}

const char* type_of(const VtkNumbers& numbers) { return numbers.values.index() == 0 ? "Int32" : "UInt8"; }

}  // namespace

std::vector<VtkPart> vtk_parts(const std::vector<std::string>& fields) {
  std::vector<VtkPart> parts;
  for (const std::string& field : fields) {
    const std::string stem = field.substr(0, field.empty() ? 0 : field.size() - 1);
    const bool vector = may_be_component(field) && has(fields, stem + "x") && has(fields, stem + "y");
    parts.push_back(vector ? VtkPart{vector_name(stem), static_cast<int>(axes.find(field.back())), true}
                           : VtkPart{field});
  }
  return parts;
}

VtkFile::VtkFile(std::filesystem::path path, const VtkShape& shape, const std::vector<std::string>& fields,
                 std::size_t count)
    : path_(std::move(path)), parts_(vtk_parts(fields)) {
  plan_fields(shape.of_cells ? "CellData" : "PointData", count);
  for (const VtkNumbers& numbers : shape.numbers)
    arrays_.push_back({numbers.section, numbers.name, type_of(numbers), 1, bytes_of(numbers)});
  std::uint64_t length = 0;
  for (Array& array : arrays_) array.offset = length, length += sizeof(array.bytes) + array.bytes;
  file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file_ < 0) fail("create the file", errno);
  try {
    write_all_but_fields(shape, length);
  } catch (const FileError&) {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);  // a part of a file would only pass for a damaged one
    ::close(file_);
    throw;
  }
}

void VtkFile::write_all_but_fields(const VtkShape& shape, std::uint64_t length) {
  const std::string text = head(shape);
  data_ = text.size();
  if (const int reason = claim_room(file_, data_ + length + tail.size()); reason != 0)
    fail("get room for the file", reason);
  write(tail.data(), tail.size(), data_ + length);
  write(text.data(), text.size(), 0);
  const std::size_t first = arrays_.size() - shape.numbers.size();
  for (std::size_t k = 0; k < shape.numbers.size(); ++k)
    std::visit([&](const auto& values) { write_array(arrays_[first + k], values.data()); }, shape.numbers[k].values);
}

VtkFile::~VtkFile() {
  if (file_ >= 0) ::close(file_);
}

/// Arrays of the fields, each where its first field is.
void VtkFile::plan_fields(const std::string& section, std::size_t count) {
  for (const VtkPart& part : parts_) {
    const bool places = part.of_vector && part.array.empty();
    const std::string name = places ? "points" : part.array;
    const auto known =
        std::find_if(arrays_.begin(), arrays_.end(), [&](const Array& array) { return array.name == name; });
    array_of_.push_back(static_cast<std::size_t>(known - arrays_.begin()));
    if (known == arrays_.end()) {
      const int components = part.of_vector ? 3 : 1;
      arrays_.push_back({places ? "Points" : section, name, "Float64", components,
                         static_cast<std::uint64_t>(components) * count * sizeof(double)});
    }
    ++arrays_[array_of_.back()].missing;
  }
}

/// All that stands before the appended data: a section after the other, each with its arrays.
std::string VtkFile::head(const VtkShape& shape) const {
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"{}\" version=\"1.0\" byte_order=\"{}Endian\" header_type=\"UInt64\">\n"
      "<{} {}>\n<Piece {}>\n",
      shape.type, std::endian::native == std::endian::little ? "Little" : "Big", shape.type, shape.attributes,
      shape.piece);
  for (const char* section : {"PointData", "CellData", "Points", "Verts", "Lines", "Polys", "Cells"}) {
    std::string arrays;
    for (const Array& array : arrays_) {
      if (array.section != section) continue;
      arrays += fmt::format(
          "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n",
          array.type, array.name, array.components, array.offset);
    }
    if (!arrays.empty()) text += fmt::format("<{0}>\n{1}</{0}>\n", section, arrays);
  }
  return text + fmt::format("</Piece>\n</{}>\n<AppendedData encoding=\"raw\">\n_", shape.type);
}

void VtkFile::write(const void* bytes, std::size_t length, std::uint64_t at) const {
  const char* from = static_cast<const char*>(bytes);
  while (length > 0) {
    const auto written = ::pwrite(file_, from, length, static_cast<off_t>(at));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("write the file", errno);
    from += written, length -= static_cast<std::size_t>(written), at += static_cast<std::uint64_t>(written);
  }
}

void VtkFile::write_array(const Array& array, const void* numbers) const {
  write(&array.bytes, sizeof(array.bytes), data_ + array.offset);
  write(numbers, array.bytes, data_ + array.offset + sizeof(array.bytes));
}

void VtkFile::put(std::size_t field, std::span<const double> numbers) {
  const VtkPart& part = parts_[field];
  Array& array = arrays_[array_of_[field]];
  if (!part.of_vector) return write_array(array, numbers.data());
  array.numbers.resize(3 * numbers.size());  // the first time: 0, which a component that lacks remains
  for (std::size_t n = 0; n < numbers.size(); ++n)
    array.numbers[3 * n + static_cast<std::size_t>(part.component)] = numbers[n];
  if (--array.missing > 0) return;
  write_array(array, array.numbers.data());
  array.numbers = {};
}

void VtkFile::close() {
  const int file = std::exchange(file_, -1);
  if (::close(file) != 0) fail("close the file", errno);
}

void VtkFile::fail(const char* doing, int reason) const {
  throw FileError(fmt::format("{}: cannot {}: {}", path_.string(), doing, std::strerror(reason)));
}

}  // namespace tether
