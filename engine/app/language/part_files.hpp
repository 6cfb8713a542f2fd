#pragma once

#include <string>
#include <vector>

#include "engine/app/language/diagram_files.hpp"

namespace stepwire::language {

/// A file that others may use as a part.
struct PartFile {
  std::string path;  ///< from the file that would use it
  std::string title;
};

/// Files with outputs around a file: all that the files knows, and those in the folders beside it.
std::vector<PartFile> part_files(DiagramFiles& files, const std::string& user);

}  // namespace stepwire::language
