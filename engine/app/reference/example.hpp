#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/model/block/block_type.hpp"

namespace stepwire::reference {

/// Returns the initial keys of a new block: its type, a preset, and its required parameters, with
/// placeholders for values that only the user can give.
std::vector<std::pair<std::string, std::string>> required_keys(const BlockType& type);

/// Returns a short entry for `blocks:`, derived from the declaration: required keys, a preset, and one or two
/// parameters.
///   lag: {block: Lag, u: source, tau: 1 s, gain: 1}
std::string block_example(const BlockType& type);

}  // namespace stepwire::reference
