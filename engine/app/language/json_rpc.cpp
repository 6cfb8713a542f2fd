#include "engine/app/language/json_rpc.hpp"

#include <fmt/format.h>

namespace stepwire::language {

using json::Json;

const Json& member(const Json& object, const char* name) {
  const Json* found = object.find(name);
  if (!found) throw ProtocolError(rpc::invalid_params, fmt::format("'{}' is missing", name));
  return *found;
}

const std::string& text_member(const Json& object, const char* name) {
  const std::string* text = member(object, name).as_text();
  if (!text) throw ProtocolError(rpc::invalid_params, fmt::format("'{}' is no text", name));
  return *text;
}

Json answer_message(const Json& id, Json result) {
  return Json::object().set("jsonrpc", "2.0").set("id", id).set("result", std::move(result));
}

Json error_message(const Json& id, int code, const std::string& message) {
  Json error = Json::object().set("code", code).set("message", message);
  return Json::object().set("jsonrpc", "2.0").set("id", id).set("error", std::move(error));
}

std::string cancelled_id(const std::string& message, const std::string& method, const char* field) {
  if (message.find(method) == std::string::npos) return "";
  try {
    const Json read = Json::parse(message);
    const Json* written = read.find("method");
    const Json* params = read.find("params");
    const Json* id = params ? params->find(field) : nullptr;
    return written && written->as_text() && *written->as_text() == method && id ? id->text(-1) : "";
  } catch (const json::JsonError&) {
    return "";
  }
}

}  // namespace stepwire::language
