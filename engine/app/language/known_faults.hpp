#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/app/language/diagram_files.hpp"
#include "engine/app/language/renaming.hpp"

namespace stepwire::language {

/// What is wrong in a diagram file as it is, to which the faults of its changed texts are compared.
class KnownFaults {
 public:
  /// The files must outlive it, and stay as they are.
  KnownFaults(DiagramFiles& files, const std::string& file);

  /// What is wrong in the file with changed texts, and not as it is.
  std::vector<yaml::Fault> added_by(const FileSplices& changes) const;
  /// The same with another tree of the file, soon.
  std::vector<yaml::Fault> added_by(yaml::Document tree) const;

 private:
  std::vector<yaml::Fault> added_in(DiagramFiles& after) const;

  DiagramFiles& files_;
  const std::string file_;
  std::vector<std::pair<std::string, std::string>> known_;  ///< subjects with their sentences
};

}  // namespace stepwire::language
