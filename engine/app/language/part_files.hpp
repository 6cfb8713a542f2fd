#pragma once

#include <string>
#include <vector>

#include "engine/app/language/diagram_files.hpp"

namespace stepwire::language {

/// Diagram file that can be used as a part.
struct PartFile {
  std::string path;  ///< relative to the folder of the using file
  std::string title;
};

/// Returns the files with outputs among all known files, except the user itself.
std::vector<PartFile> part_files(DiagramFiles& files, const std::string& user);

}  // namespace stepwire::language
