#pragma once

#include <map>
#include <string>

#include "engine/app/language/diagram_files.hpp"

namespace stepwire::language {

/// Returns the text range of each item in the drawing of a file. Items are blocks with their keys, inputs
/// with their sources, and outputs, at the name of their block.
/// Names are those of the drawn graph: "cart", "cart.force", "sum.u.2" for lists, "rig.mount.x" within parts
/// (in their own files), "x" for ports of the file.
/// While the text is invalid YAML, the last valid one counts.
std::map<std::string, FilePlace> shape_places(DiagramFiles& files, const std::string& file);

}  // namespace stepwire::language
