#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/model/block/block_type.hpp"

namespace stepwire::reference {

/// The keys that a new block begins with: its kind, a preset, and the parameters that it requires, each with
/// something that may stand for a value which only the user knows.
std::vector<std::pair<std::string, std::string>> required_keys(const BlockType& type);

/// A short entry for `blocks:` made from a declaration: what must be given, a preset, and a parameter or two.
///   lag: {block: Lag, u: source, tau: 1 s, gain: 1}
std::string block_example(const BlockType& type);

}  // namespace stepwire::reference
