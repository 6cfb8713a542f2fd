#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/app/language/diagram_files.hpp"
#include "engine/app/language/renaming.hpp"

namespace stepwire::language {

/// Present faults of a diagram file, with which those of changed texts are compared.
class KnownFaults {
 public:
  /// The files must outlive the object and stay unchanged.
  KnownFaults(DiagramFiles& files, const std::string& file);

  /// Returns the faults that the changes add.
  std::vector<yaml::Fault> added_by(const FileSplices& changes) const;
  /// Returns the faults that a changed tree adds. It is fast, since no text is parsed.
  std::vector<yaml::Fault> added_by(yaml::Document tree) const;

 private:
  std::vector<yaml::Fault> added_in(DiagramFiles& after) const;

  DiagramFiles& files_;
  const std::string file_;
  std::vector<std::pair<std::string, std::string>> known_;  ///< subjects and messages
};

}  // namespace stepwire::language
