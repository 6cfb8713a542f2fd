#pragma once

#include <string>
#include <string_view>

#include "engine/model/block/block_type.hpp"

namespace stepwire {

/// Gives the type of a block whose ports stand in a file, such as a unit of others: as the registered type of
/// its name, with the ports of this file. `word` is the value of its key `interface`, or empty. The type
/// lasts as long as the program. Throws std::runtime_error with what is wrong with the file.
using TypeOfFile = const BlockType& (*)(const std::string& file, const std::string& word);

/// Notes that blocks of this name have the ports that their key `file` gives. Safe from several threads.
void note_typed_by_file(const std::string& name, TypeOfFile of);

/// Null for blocks whose declaration has their ports.
TypeOfFile find_typed_by_file(std::string_view name);

}  // namespace stepwire
