#pragma once

#include <string>
#include <string_view>

namespace stepwire::mat {

/// Returns the bytes as a gzip file without time and file name.
std::string gzip_packed(std::string_view bytes);

}  // namespace stepwire::mat
