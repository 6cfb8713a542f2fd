#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace stepwire::mat {

/// The first bytes of what was packed by zlib, at most `most`. Throws TableError where it is damaged.
std::string inflate_start(std::string_view packed, std::size_t most);

/// All of it, `size` bytes. Throws TableError where it is damaged, by its checksum too, or has another size.
std::string inflate_all(std::string_view packed, std::size_t size);

}  // namespace stepwire::mat
