#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/app/language/analysis.hpp"
#include "engine/app/language/text_places.hpp"

namespace stepwire::language {

/// Changes of several files, each list in the order of the text.
using FileSplices = std::map<std::string, std::vector<Splice>>;

/// Returns the piece of a name at an offset that can be renamed. Throws EditRefused.
NamePiece renamed_piece(DiagramFiles& files, const std::string& file, std::size_t offset);

/// Renames all uses in all known files. Throws EditRefused if the new name is invalid or used, or if a file
/// that may contain the name is unreadable. Also throws if a valid file would get faults.
FileSplices rename(DiagramFiles& files, const std::string& file, std::size_t offset, const std::string& name);

}  // namespace stepwire::language
