#pragma once

#include <string>

#include "engine/model/block/block_type.hpp"

namespace stepwire {

/// A member of a block, by its name in C++, as a program would set it; lists of numbers in braces. Fails the
/// test if the block's declaration has no such member.
std::string literal_text(const BlockType& type, const void* block, const std::string& member);

}  // namespace stepwire
