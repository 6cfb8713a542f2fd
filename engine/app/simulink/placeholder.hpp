#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include "engine/app/simulink/block_writer.hpp"

namespace stepwire::simulink {

// A block without counterpart becomes a part. A run of it ends at its first step, at a block whose name is
// the task.

/// Wires a block to its part.
void use_placeholder(BlockWriter& write, const std::string& reference);

/// Numbers of elements that other blocks read of outputs, by block and port.
using ElementsRead = std::map<std::pair<std::size_t, int>, std::size_t>;
ElementsRead elements_read(const FlatModel& model);

/// Returns the text of the part of a block.
std::string placeholder_text(const BlockWriter& write, const std::string& reason, std::size_t index,
                             const ElementsRead& read);

}  // namespace stepwire::simulink
