#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace stepwire::hdf5 {

/// Writes a MATLAB file of level 7.3: an HDF5 file behind a header of 512 bytes, whose objects say by the
/// attribute MATLAB_class what they are. It appears whole under its name or not at all, and the same content
/// gives the same bytes. Methods throw EnvironmentError where the system refuses. Layout: what MATLAB R2006b
/// and later write, as matio and Octave read it.
class MatlabFile {
 public:
  /// `header` has 128 bytes.
  MatlabFile(const std::string& path, std::string header);
  ~MatlabFile();
  MatlabFile(const MatlabFile&) = delete;
  MatlabFile& operator=(const MatlabFile&) = delete;

  /// A matrix of doubles, column by column.
  void add(const std::string& name, std::size_t rows, std::size_t columns, std::span<const double> values);
  /// A cell array of texts, one below the other.
  void add(const std::string& name, const std::vector<std::u16string>& texts);
  /// Gives the file its name.
  void finish();

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace stepwire::hdf5
