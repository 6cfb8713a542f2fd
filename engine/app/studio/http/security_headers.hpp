#pragma once

#include <string>
#include <vector>

#include "engine/app/studio/http/message.hpp"

namespace stepwire::http {

/// The headers that every answer has: nothing is kept or framed, nothing is loaded from elsewhere, and styles
/// come from us or carry the nonce.
std::vector<Header> security_headers(const std::string& nonce);

}  // namespace stepwire::http
