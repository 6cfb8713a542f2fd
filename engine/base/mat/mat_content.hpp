#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace stepwire::mat {

/// Kinds of numbers in a MAT file, as its level 5 counts them.
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

/// Bytes of one; 0 for a kind that is none.
std::size_t mat_number_size(MatNumber kind);

/// The numbers that fill the bytes, whose order is swapped where it is not this machine's.
std::vector<double> mat_numbers(std::string_view bytes, MatNumber kind, bool swap);

/// A real array: its size in each dimension, and its values, column by column.
struct MatVariable {
  std::string name;
  std::vector<std::size_t> size;
  std::vector<double> values;
};

/// A variable that is no real array, and the sentence for people about it.
struct MatProblem {
  std::string name, text;
};

constexpr std::size_t max_structs = 1000;  ///< of an array of structs that is read
constexpr std::size_t max_depth = 16;      ///< of structs in structs

/// Contents of a MAT file: real arrays, those of structs with the path of their field as
/// `out.signals.values`, and of files of our own the names and units of the columns.
struct MatContent {
  std::vector<MatVariable> variables;
  std::vector<MatProblem> problems;
  bool has_foreign = false;  ///< of level 7.3: datasets that other programs wrote
  std::vector<std::string> names, units;
};

/// The name of an element of an array of structs, "out.signals(2)"; that of the array where it has one.
std::string mat_element(const std::string& path, std::size_t index, std::size_t count);

/// The product of sizes. Throws TableError where it is beyond any memory.
std::size_t mat_count(const std::vector<std::size_t>& size);

/// These throw TableError, without the name of the file, where an element is cut off, of an unknown type or
/// does not have as many numbers as its dimensions say. Level 7.3 is read by the libraries for HDF5,
/// in a process of its own.
MatContent read_mat_level_4(std::string_view file);
MatContent read_mat_level_5(std::string_view file, bool swap);
MatContent read_mat_level_7(const std::string& path, std::size_t file_size);

}  // namespace stepwire::mat
