#pragma once

#include <string>
#include <string_view>

namespace stepwire::hash {

/// Returns the SHA-256 (FIPS 180-4) of a text in 64 hexadecimal digits, as the program sha256sum prints it.
/// No two texts of one hash are known, so it identifies content from elsewhere.
std::string sha256_of(std::string_view text);

}  // namespace stepwire::hash
