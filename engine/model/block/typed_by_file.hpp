#pragma once

#include <string>
#include <string_view>

#include "engine/model/block/block_type.hpp"

namespace stepwire {

/// Function that returns the block type described by a file, such as an FMU. It is the registered type of its
/// name, with the ports of this file. `word` is the value of its key `interface`, or empty. The type lives
/// until the program ends. Throws std::runtime_error for an invalid file.
using TypeOfFile = const BlockType& (*)(const std::string& file, const std::string& word);

/// Registers that blocks of this name have the ports described by their key `file`. Thread-safe.
void note_typed_by_file(const std::string& name, TypeOfFile of);

/// Returns the function of a name; nullptr for blocks with declared ports.
TypeOfFile find_typed_by_file(std::string_view name);

}  // namespace stepwire
