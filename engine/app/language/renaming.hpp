#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/app/language/analysis.hpp"
#include "engine/app/language/splice.hpp"

namespace stepwire::language {

/// Changes of several files, each in the order of its text.
using FileSplices = std::map<std::string, std::vector<Splice>>;

/// The piece of a name at a place that may be changed. Throws EditRefused.
NamePiece renamed_piece(DiagramFiles& files, const std::string& file, std::size_t offset);

/// Changes a name wherever it stands, in all files that the files knows. Throws EditRefused where the
/// new name is none or is taken, where a file that may have it cannot be read, and where a file that was
/// right would have faults.
FileSplices rename(DiagramFiles& files, const std::string& file, std::size_t offset, const std::string& name);

}  // namespace stepwire::language
