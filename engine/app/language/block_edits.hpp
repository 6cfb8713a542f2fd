#pragma once

#include <string>

#include "engine/app/language/edits.hpp"
#include "engine/app/language/tree_edits.hpp"

namespace stepwire::language {

/// Removes a block, part or parameter. Its names are also removed from lists outside of `blocks` that have
/// other items. Other uses stay and become faults. Throws EditRefused for an unknown name.
void remove(TreeEdits& edits, DiagramFiles& files, const std::string& file, const yaml::Document& document,
            const Remove& edit);

/// Adds a block with its required keys and its sources, and returns its name. Throws EditRefused for an
/// unknown type, and for wires with unknown ends.
std::string insert(TreeEdits& edits, DiagramFiles& files, const std::string& file,
                   const yaml::Document& document, const Insert& edit);

}  // namespace stepwire::language
