#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace stepwire::hdf5 {

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
