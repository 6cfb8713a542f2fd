#pragma once

#include <string>
#include <string_view>

namespace stepwire::mat {

/// Returns the bytes packed as a file of gzip, which names neither a time nor a file.
std::string gzip_packed(std::string_view bytes);

}  // namespace stepwire::mat
