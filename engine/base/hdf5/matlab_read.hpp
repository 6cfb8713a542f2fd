#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace stepwire::hdf5 {

/// An array of real numbers in column-major order. A field of a struct is named by its path:
/// "out.signals(2).values".
struct MatlabArray {
  std::string name;
  std::vector<std::size_t> size;
  std::vector<double> values;
};

/// A variable that is not an array of real numbers.
struct MatlabOther {
  enum class Kind { complex, sparse, cell, function, object, struct_array, outside };

  std::string name;
  Kind kind;
  std::string class_name;  ///< of an object, such as "timeseries"
};

/// A cell array of texts, each in 16-bit code units.
struct MatlabTexts {
  std::string name;
  std::vector<std::vector<double>> texts;
};

struct MatlabContent {
  std::vector<MatlabArray> arrays;
  std::vector<MatlabOther> others;
  std::vector<MatlabTexts> texts;
  bool has_foreign = false;  ///< datasets written by other programs
};

struct MatlabLimits {
  std::size_t structs;  ///< most elements of a struct array that is read
  std::size_t depth;    ///< nesting of structs
};

/// Reads a MATLAB file of level 7.3, an HDF5 file whose objects have their class in the attribute
/// MATLAB_class. The cell arrays in `text_lists` are read as texts. Characters and empty arrays are left out.
/// Reads in this process and requires a Session. Throws TableError, without the name of the file, for damage.
MatlabContent read_matlab(const std::string& path, std::size_t file_size, const MatlabLimits& limits,
                          const std::vector<std::string>& text_lists);

}  // namespace stepwire::hdf5
