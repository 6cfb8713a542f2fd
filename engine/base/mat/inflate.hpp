#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace stepwire::mat {

/// Decompresses the first `most` bytes of a zlib stream. Throws TableError for a damaged stream.
std::string inflate_start(std::string_view packed, std::size_t most);

/// Decompresses a zlib stream of `size` bytes. Throws TableError for damage, a wrong checksum or another
/// size.
std::string inflate_all(std::string_view packed, std::size_t size);

}  // namespace stepwire::mat
