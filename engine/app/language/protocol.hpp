#pragma once

#include <stdexcept>
#include <string>

#include "engine/app/language/language_service.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire::language {

/// Message that violates the protocol. The code is one of JSON-RPC or of the protocol.
class ProtocolError : public std::runtime_error {
 public:
  ProtocolError(int code, const std::string& message) : std::runtime_error(message), code(code) {}
  int code;
};

namespace rpc {
constexpr int parse_error = -32700, invalid_request = -32600, no_method = -32601, invalid_params = -32602,
              internal_error = -32603, not_initialized = -32002, request_cancelled = -32800,
              request_failed = -32803;
}

// Fields of messages. Each function throws ProtocolError if the field is missing or malformed.
const json::Json& member(const json::Json& object, const char* name);
const std::string& text_member(const json::Json& object, const char* name);
EditorPosition position_of(const json::Json& position);
EditorRange range_of(const json::Json& range);

json::Json json_of(const EditorPosition& position);
json::Json json_of(const EditorRange& range);
json::Json json_of(const Completion& completion, const EditorRange& range, int order);
json::Json json_of(const OutlineItem& item);

}  // namespace stepwire::language
