#include "engine/app/language/edit_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <map>

#include "engine/base/text/characters.hpp"

namespace stepwire::language {

namespace {

std::string text_under(const json::Json& edit, const char* key) {
  const json::Json* value = edit.find(key);
  const std::string* text = value ? value->as_text() : nullptr;
  if (!text) throw EditRefused(fmt::format("this edit needs a text '{}'", key));
  return *text;
}

/// Parses an edit of a value, which may be a number, a word or an expression.
Edit value_edit(const json::Json& edit) {
  const json::Json* at = edit.find("at");
  if (!at) return SetValue{text_under(edit, "name"), text_under(edit, "text")};
  const double place = at->as_number().value_or(-1.0);
  if (!(place >= 0.0 && place <= 1e9 && place == std::floor(place)))
    throw EditRefused("'at' is a place of the text");
  return SetValueAt{static_cast<std::size_t>(place), text_under(edit, "text")};
}

Edit insert_edit(const json::Json& edit) {
  const json::Json* name = edit.find("name");
  Insert insert{text_under(edit, "type"), name && !name->is_null() ? text_under(edit, "name") : ""};
  if (const json::Json* inputs = edit.find("inputs"))
    for (const json::Json& fed : inputs->items())
      insert.inputs.emplace_back(text_under(fed, "input"), text_under(fed, "from"));
  return insert;
}

using Reading = std::function<Edit(const json::Json&)>;

const std::map<std::string, Reading>& readings() {
  static const std::map<std::string, Reading> all{
      {"number", value_edit},
      {"word", value_edit},
      {"insert", insert_edit},
      {"rename",
       [](const json::Json& e) {
         return Rename{text_under(e, "name"), text_under(e, "to")};
       }},
      {"connect",
       [](const json::Json& e) {
         return Connect{text_under(e, "from"), text_under(e, "to"), text_under(e, "input")};
       }},
      {"disconnect",
       [](const json::Json& e) {
         return Disconnect{text_under(e, "to"), text_under(e, "input")};
       }},
      {"delete", [](const json::Json& e) { return Remove{text_under(e, "name")}; }},
      {"item",
       [](const json::Json& e) {
         return AddItem{text_under(e, "section"), text_under(e, "text")};
       }},
      {"bode", [](const json::Json& e) {
         return CutLoop{text_under(e, "signal"), e.find("at") ? text_under(e, "at") : ""};
       }}};
  return all;
}

}  // namespace

Edit edit_of(const json::Json& edit) {
  const std::string kind = text_under(edit, "kind");
  const auto reading = readings().find(kind);
  if (reading == readings().end())
    throw EditRefused(fmt::format("there is no edit '{}'", text::visible(kind)));
  return reading->second(edit);
}

}  // namespace stepwire::language
