#pragma once

#include <string>
#include <vector>

#include "engine/app/studio/http/message.hpp"

namespace stepwire::http {

/// Returns the headers of every answer: no caching, no framing, no resources from other origins. Styles must
/// come from this origin or carry the nonce.
std::vector<Header> security_headers(const std::string& nonce);

}  // namespace stepwire::http
