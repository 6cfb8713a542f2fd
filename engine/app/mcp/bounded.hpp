#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/base/json/json.hpp"

namespace stepwire::mcp {

/// Bytes of JSON that an answer has at most.
inline constexpr std::size_t most_bytes = 100'000;

/// Returns a value whose JSON has at most `most` bytes: items of long lists, evenly chosen with the first and
/// the last, and beginnings of long texts. Each shortened value has a line in `notes`.
json::Json bounded(const json::Json& value, std::size_t most, std::vector<std::string>& notes);

/// Returns `count` indices below `size`, evenly chosen with the first and the last; all if there are fewer.
std::vector<std::size_t> even_indices(std::size_t size, std::size_t count);

}  // namespace stepwire::mcp
