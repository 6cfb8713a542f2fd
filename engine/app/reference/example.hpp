#pragma once

#include <string>

#include "engine/model/block/block_type.hpp"

namespace stepwire::reference {

/// A short entry for `blocks:` made from a declaration: what must be given, a preset, and a parameter or two.
///   lag: {block: Lag, u: source, tau: 1 s, gain: 1}
std::string block_example(const BlockType& type);

}  // namespace stepwire::reference
