#pragma once

#include <string>

#include "engine/app/language/edits.hpp"
#include "engine/app/language/tree_edits.hpp"

namespace stepwire::language {

/// Removes a block, part or parameter, and its names out of lists outside of the blocks where such a list has
/// others. All else that names it stays, and is a fault then. Throws EditRefused where there is none.
void remove(TreeEdits& edits, DiagramFiles& files, const std::string& file, const yaml::Document& document,
            const Remove& edit);

/// Adds a block with what it requires and what feeds it, and returns its name. Throws EditRefused for a type
/// that is not known, and for wires from or to what is not there.
std::string insert(TreeEdits& edits, DiagramFiles& files, const std::string& file,
                   const yaml::Document& document, const Insert& edit);

}  // namespace stepwire::language
