#pragma once

#include <string>

#include "engine/app/simulink/block_writer.hpp"

namespace stepwire::simulink {

/// Wires a block to a part that stands for it, and returns the text of that part. A run of the part ends at
/// its first step, at a block whose name says what to do.
std::string write_placeholder(BlockWriter& write, const std::string& reference, const std::string& reason);

}  // namespace stepwire::simulink
