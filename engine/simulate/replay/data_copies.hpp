#pragma once

#include <map>
#include <set>
#include <string>

namespace stepwire::replay {

/// Copies of data files, each with a unique name, to be written into one folder.
class DataCopies {
 public:
  /// Returns the name of the file at this path in the folder. It is its own name, with a number if two are
  /// the same, and with '_' for characters that a diagram file could misread. Throws EnvironmentError if it
  /// cannot be read.
  const std::string& name_of(const std::string& path);
  /// Writes all copies; files that they replace have been read before. Throws EnvironmentError.
  void write(const std::string& folder) const;

 private:
  struct Copy {
    std::string name, content;
  };
  std::string free_name(const std::string& path) const;

  std::map<std::string, Copy> copies_;  ///< by absolute path
  std::set<std::string> taken_;
};

}  // namespace stepwire::replay
