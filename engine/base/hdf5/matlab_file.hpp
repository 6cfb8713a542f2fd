#pragma once

#include <cstddef>
#include <memory>
#include <span>
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

/// Writes a MATLAB file of level 7.3: an HDF5 file behind a header of 512 bytes. The attribute MATLAB_class
/// of each object is its class. The file appears under its name complete or not at all, and the same content
/// gives the same bytes. Methods throw EnvironmentError where the system refuses. The layout is that of
/// MATLAB R2006b and later, as matio and Octave read it.
class MatlabFile {
 public:
  /// Creates the temporary file; `header` has 128 bytes.
  MatlabFile(const std::string& path, std::string header);
  ~MatlabFile();
  MatlabFile(const MatlabFile&) = delete;
  MatlabFile& operator=(const MatlabFile&) = delete;

  /// Adds a matrix of doubles in column-major order.
  void add(const std::string& name, std::size_t rows, std::size_t columns, std::span<const double> values);
  /// Adds a cell array of texts as one column.
  void add(const std::string& name, const std::vector<std::u16string>& texts);
  /// Closes the file and renames it to its final name.
  void finish();

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace stepwire::hdf5
