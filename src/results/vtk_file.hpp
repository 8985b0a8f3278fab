// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace tether {

/// Whole numbers of a VTK file that say which points its cells have.
struct VtkNumbers {
  std::string section;  ///< element of the file that they stand in: "Cells", "Verts", "Polys"
  std::string name;
  std::variant<std::vector<std::int32_t>, std::vector<std::uint8_t>> values;
};

/// What a VTK file has beside its fields.
struct VtkShape {
  std::string type;                   ///< "PolyData", "UnstructuredGrid" or "ImageData"
  std::string attributes;             ///< of the element of that name
  std::string piece;                  ///< attributes of its only piece
  std::vector<VtkNumbers> numbers{};  ///< in the order of their sections
  bool of_cells = false;              ///< whether fields are of cells; else of points
};

/// Where a field's numbers stand in a VTK file: alone in an array, or as a component of a vector.
struct VtkPart {
  std::string array;  ///< "p"; "v" of vx, vy and vz; "" of x, y and z, the places of the points
  int component = 0;  ///< from 0
  bool of_vector = false;
};

/// Says what each of these fields is in a VTK file: names that end in x and y (and z) after the same text are a vector,
/// but where that text ends in x, y or z itself: sxx and sxy are components of a tensor, and stay numbers.
std::vector<VtkPart> vtk_parts(const std::vector<std::string>& fields);

/// A VTK file of XML with its numbers appended as bytes: fields of 8 byte floating point, which are put one after the
/// other. Components that a vector lacks are 0. Source: VTK, "VTK file formats", XML, appended raw data.
class VtkFile {
 public:
  /// Creates the file with room for all of it, and writes what is no field; each field has `count` numbers. Throws
  /// FileError, as all members do.
  VtkFile(std::filesystem::path path, const VtkShape& shape, const std::vector<std::string>& fields, std::size_t count);
  ~VtkFile();
  VtkFile(const VtkFile&) = delete;
  VtkFile& operator=(const VtkFile&) = delete;

  /// The numbers of a field, counted from 0.
  void put(std::size_t field, std::span<const double> numbers);
  void close();

 private:
  /// An array of the file: its bytes begin with their number.
  struct Array {
    std::string section, name;
    const char* type;
    int components;
    std::uint64_t bytes;
    std::uint64_t offset = 0;          // from the start of the appended data
    std::vector<double> numbers = {};  // of a vector, until all its components are there
    int missing = 0;                   // components that are not
  };

  void plan_fields(const std::string& section, std::size_t count);
  void write_all_but_fields(const VtkShape& shape, std::uint64_t length);
  std::string head(const VtkShape& shape) const;
  void write(const void* bytes, std::size_t length, std::uint64_t at) const;
  void write_array(const Array& array, const void* numbers) const;
  [[noreturn]] void fail(const char* doing, int reason) const;

  std::filesystem::path path_;
  std::vector<VtkPart> parts_;
  std::vector<std::size_t> array_of_;  // each field's
  std::vector<Array> arrays_;
  std::uint64_t data_ = 0;  // where the appended data begin
  int file_ = -1;
};

}  // namespace tether
