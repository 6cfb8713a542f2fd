#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace stepwire::hdf5 {

/// An array of real numbers, column by column as MATLAB has it. A field of a struct has its path as the name:
/// "out.signals(2).values".
struct MatlabArray {
  std::string name;
  std::vector<std::size_t> size;
  std::vector<double> values;
};

/// A variable that is no array of real numbers.
struct MatlabOther {
  enum class Kind { complex, sparse, cell, function, object, struct_array, outside };

  std::string name;
  Kind kind;
  std::string class_name;  ///< of an object, as "timeseries"
};

/// A cell array of texts, each in 16-bit units.
struct MatlabTexts {
  std::string name;
  std::vector<std::vector<double>> texts;
};

struct MatlabContent {
  std::vector<MatlabArray> arrays;
  std::vector<MatlabOther> others;
  std::vector<MatlabTexts> texts;
  bool has_foreign = false;  ///< datasets that other programs wrote
};

struct MatlabLimits {
  std::size_t structs;  ///< of an array of structs that is read
  std::size_t depth;    ///< of structs in structs
};

/// Reads a MATLAB file of level 7.3: objects of an HDF5 file whose attribute MATLAB_class is their class. The
/// cell arrays of these names are read as texts. Characters and empty arrays are left out. Reads in this
/// process, and needs a Session. Throws TableError, without the name of the file, where it is damaged.
MatlabContent read_matlab(const std::string& path, std::size_t file_size, const MatlabLimits& limits,
                          const std::vector<std::string>& text_lists);

}  // namespace stepwire::hdf5
