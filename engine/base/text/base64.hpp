#pragma once

#include <string>
#include <string_view>

namespace stepwire::text {

/// Returns bytes as letters, digits, '+' and '/', padded by '=' (RFC 4648).
std::string base64(std::string_view bytes);

}  // namespace stepwire::text
