#include "engine/app/language/protocol.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace stepwire::language {

using json::Json;

namespace {

int whole(const Json& object, const char* name) {
  const auto number = member(object, name).as_number();
  if (!number || !(*number >= 0.0))
    throw ProtocolError(rpc::invalid_params, fmt::format("'{}' is no number from 0 on", name));
  return static_cast<int>(std::min<double>(*number, std::numeric_limits<int>::max()));
}

/// Returns the CompletionItemKind of the protocol.
int kind_of(Completion::Kind kind) {
  switch (kind) {
    case Completion::Kind::key:
      return 10;  // Property
    case Completion::Kind::type:
      return 7;  // Class
    case Completion::Kind::word:
      return 12;  // Value
    case Completion::Kind::signal:
      return 6;  // Variable
    case Completion::Kind::parameter:
      return 21;  // Constant
    case Completion::Kind::unit:
      return 11;  // Unit
    default:
      return 17;  // File
  }
}

/// Returns the SymbolKind of the protocol.
int kind_of(OutlineItem::Kind kind) {
  switch (kind) {
    case OutlineItem::Kind::section:
      return 3;  // Namespace
    case OutlineItem::Kind::block:
      return 19;  // Object
    case OutlineItem::Kind::part:
      return 2;  // Module
    case OutlineItem::Kind::parameter:
      return 14;  // Constant
    case OutlineItem::Kind::port:
      return 8;  // Field
    default:
      return 17;  // Boolean
  }
}

}  // namespace

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

EditorPosition position_of(const Json& position) {
  return {whole(position, "line"), whole(position, "character")};
}

EditorRange range_of(const Json& range) {
  return {position_of(member(range, "start")), position_of(member(range, "end"))};
}

Json json_of(const EditorPosition& position) {
  return Json::object().set("line", position.line).set("character", position.character);
}

Json json_of(const EditorRange& range) {
  return Json::object().set("start", json_of(range.start)).set("end", json_of(range.end));
}

Json json_of(const Completion& completion, const EditorRange& range, int order) {
  Json edit = Json::object().set("range", json_of(range)).set("newText", completion.text);
  Json item = Json::object()
                  .set("label", completion.label)
                  .set("kind", kind_of(completion.kind))
                  .set("sortText", fmt::format("{:06}", order))
                  .set("textEdit", std::move(edit));
  if (!completion.detail.empty()) item.set("detail", completion.detail);
  if (!completion.doc.empty())
    item.set("documentation", Json::object().set("kind", "markdown").set("value", completion.doc));
  return item;
}

Json json_of(const OutlineItem& item) {
  Json children = Json::list();
  for (const OutlineItem& child : item.children) children.push(json_of(child));
  return Json::object()
      .set("name", item.name)
      .set("detail", item.detail)
      .set("kind", kind_of(item.kind))
      .set("range", json_of(item.range))
      .set("selectionRange", json_of(item.name_range))
      .set("children", std::move(children));
}

}  // namespace stepwire::language
