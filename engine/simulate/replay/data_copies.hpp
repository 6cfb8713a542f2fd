#pragma once

#include <map>
#include <set>
#include <string>

namespace stepwire::replay {

/// Data files as they are now, each under a name of its own, to be written into one folder.
class DataCopies {
 public:
  /// What the file at this path is called in the folder: its own name, with a number where two have the same
  /// and with '_' for what a diagram file could misread. Throws EnvironmentError where it cannot be read.
  const std::string& name_of(const std::string& path);
  /// Writes them all; what they replace has been read before. Throws EnvironmentError.
  void write(const std::string& folder) const;

 private:
  struct Copy {
    std::string name, content;
  };
  std::string free_name(const std::string& path) const;

  std::map<std::string, Copy> copies_;  ///< by the path from the root
  std::set<std::string> taken_;
};

}  // namespace stepwire::replay
