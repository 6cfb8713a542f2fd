#pragma once

#include <string>

#include "engine/app/simulink/block_writer.hpp"

namespace stepwire::simulink {

/// Returns a condition of MATLAB over u1, u2, ... as a formula of the sources of a block. Throws
/// Untranslated.
std::string condition_of(BlockWriter& write, const std::string& text);

}  // namespace stepwire::simulink
