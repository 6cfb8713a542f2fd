#pragma once

#include <map>
#include <string>

#include "engine/app/language/diagram_files.hpp"

namespace stepwire::language {

/// Where the text has what a drawing of the file shows: each block with its keys, each input with what feeds
/// it, an output at the name of its block. Names are those of the graph that is drawn: "cart", "cart.force",
/// of a list "sum.u.2", inside of parts "rig.mount.x", of the file's own ports "x"; also those inside of
/// parts, in the files of these. Of a file that is no YAML just now the last one that was.
std::map<std::string, FilePlace> shape_places(DiagramFiles& files, const std::string& file);

}  // namespace stepwire::language
