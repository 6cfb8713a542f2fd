#pragma once

#include <stdexcept>
#include <string>

#include "engine/base/json/json.hpp"

namespace stepwire::language {

/// Error codes of JSON-RPC 2.0, and of the Language Server Protocol.
namespace rpc {
inline constexpr int parse_error = -32700, invalid_request = -32600, no_method = -32601,
                     invalid_params = -32602, internal_error = -32603, not_initialized = -32002,
                     request_cancelled = -32800, request_failed = -32803;
}

/// Message that violates the protocol. The code is one of `rpc`.
class ProtocolError : public std::runtime_error {
 public:
  ProtocolError(int code, const std::string& message) : std::runtime_error(message), code(code) {}
  int code;
};

/// Returns a field of a message. Throws ProtocolError if it is missing.
const json::Json& member(const json::Json& object, const char* name);
/// Returns a text of a message. Throws ProtocolError if it is missing or no text.
const std::string& text_member(const json::Json& object, const char* name);

/// Returns the message that answers a request.
json::Json answer_message(const json::Json& id, json::Json result);
/// Returns the message that refuses a request.
json::Json error_message(const json::Json& id, int code, const std::string& message);

/// Returns the `id` in the parameters of a cancelling notification, as JSON text; empty for any other
/// message. `field` is the name of that parameter: "id", "requestId".
std::string cancelled_id(const std::string& message, const std::string& method, const char* field);

}  // namespace stepwire::language
