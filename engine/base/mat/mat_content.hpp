#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace stepwire::mat {

/// Number types of a MAT file, with the codes of level 5.
enum class MatNumber : std::uint32_t {
  int8 = 1,
  uint8 = 2,
  int16 = 3,
  uint16 = 4,
  int32 = 5,
  uint32 = 6,
  float32 = 7,
  float64 = 9,
  int64 = 12,
  uint64 = 13
};

/// Returns the size of a number in bytes; 0 for an unknown type.
std::size_t mat_number_size(MatNumber kind);

/// Decodes numbers from bytes; `swap` reverses their byte order.
std::vector<double> mat_numbers(std::string_view bytes, MatNumber kind, bool swap);

/// A real array: its size in each dimension, and its values in column-major order.
struct MatVariable {
  std::string name;
  std::vector<std::size_t> size;
  std::vector<double> values;
};

/// A variable that is not a real array, and the message about it.
struct MatProblem {
  std::string name, text;
};

constexpr std::size_t max_structs = 1000;  ///< most elements of a struct array that is read
constexpr std::size_t max_depth = 16;      ///< nesting of structs

/// Contents of a MAT file: real arrays, where a field of a struct is named by its path `out.signals.values`.
/// Files written by this program also have the names and units of the columns.
struct MatContent {
  std::vector<MatVariable> variables;
  std::vector<MatProblem> problems;
  bool has_foreign = false;  ///< of level 7.3: datasets written by other programs
  std::vector<std::string> names, units;
};

/// Returns the name of an element of a struct array, "out.signals(2)"; the name of the array itself for one
/// element.
std::string mat_element(const std::string& path, std::size_t index, std::size_t count);

/// Returns the product of the sizes. Throws TableError on overflow.
std::size_t mat_count(const std::vector<std::size_t>& size);

/// Read the levels of the format. Throw TableError, without the name of the file, for truncated elements,
/// unknown types and numbers that do not match their dimensions. The HDF5 library reads level 7.3 in a
/// process of its own.
MatContent read_mat_level_4(std::string_view file);
MatContent read_mat_level_5(std::string_view file, bool swap);
MatContent read_mat_level_7(const std::string& path, std::size_t file_size);

}  // namespace stepwire::mat
