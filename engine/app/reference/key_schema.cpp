#include "engine/app/reference/key_schema.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "engine/app/reference/schema_values.hpp"
#include "engine/base/yaml/choices.hpp"

namespace stepwire::reference {

using json::Json;

namespace {

/// Converts a word to its YAML type: 1 becomes a number, true a boolean.
Json scalar(const std::string& text) {
  if (text == "true" || text == "false") return Json(text == "true");
  double number = 0.0;
  const char* const end = text.data() + text.size();
  if (std::from_chars(text.data(), end, number).ptr != end || text.empty()) return Json(text);
  return number == std::floor(number) ? Json(static_cast<int>(number)) : Json(number);
}

Json whole_schema(const yaml::Key& key) {
  Json schema = typed("integer").set("minimum", static_cast<long>(key.least));
  if (std::isfinite(key.most)) schema.set("maximum", static_cast<long>(key.most));
  return schema;
}

Json number_schema(const yaml::Key& key) {
  const bool bounded = std::isfinite(key.least) || std::isfinite(key.most);
  if (!bounded) return schema_ref("number");
  if (key.unit == "s" && key.above && key.least == 0.0) return schema_ref("time");
  Range range;
  if (std::isfinite(key.least)) (key.above ? range.above : range.at_least) = key.least;
  if (std::isfinite(key.most)) range.at_most = key.most;
  return number_in(range);
}

Json word_schema(const yaml::Key& key) {
  Json words = Json::list();
  const bool explained_words =
      std::ranges::any_of(key.words, [](const yaml::Key::Word& word) { return !word.doc.empty(); });
  for (const yaml::Key::Word& word : key.words)
    words.push(explained_words ? explained(Json::object().set("const", scalar(word.word)), word.doc)
                               : scalar(word.word));
  return Json::object().set(explained_words ? "anyOf" : "enum", std::move(words));
}

Json list_schema(const yaml::Key& key) {
  Json schema = list_of(key_schema(key.of.front()));
  if (key.least > 0) schema.set("minItems", static_cast<long>(key.least));
  if (std::isfinite(key.most)) schema.set("maxItems", static_cast<long>(key.most));
  return schema;
}

Json names_schema(const yaml::Key& key) {
  Json schema = typed("object");
  if (!key.pattern.empty()) schema.set("propertyNames", Json::object().set("pattern", key.pattern));
  if (key.least > 0) schema.set("minProperties", static_cast<long>(key.least));
  if (std::isfinite(key.most)) schema.set("maxProperties", static_cast<long>(key.most));
  return schema.set("additionalProperties", key_schema(key.of.front()));
}

Json required(const std::string& name) {
  return Json::object().set("required", Json::list({Json(name)}));
}

/// Requires one of its companion keys beside a key that has several.
Json companion_of(const yaml::Key& key) {
  Json others = Json::list();
  for (const std::string& other : key.beside) others.push(required(other));
  return Json::object()
      .set("if", required(key.name))
      .set("then", Json::object().set("anyOf", std::move(others)));
}

/// Requires exactly one key of each choice, and one companion of each key that has several.
std::vector<Json> rules_of(const yaml::Key& map) {
  std::map<std::string, Json> choices;
  std::vector<Json> all;
  for (const yaml::Key& key : map.of) {
    for (const std::string& choice : yaml::choice_groups(key)) choices[choice].push(required(key.name));
    if (key.beside.size() > 1) all.push_back(companion_of(key));
  }
  for (auto& [name, keys] : choices) all.push_back(Json::object().set("oneOf", std::move(keys)));
  return all;
}

/// Lists the keys that require exactly one companion key.
Json companions_of(const yaml::Key& map) {
  Json all;
  for (const yaml::Key& key : map.of)
    if (key.beside.size() == 1) all.set(key.name, Json::list({Json(key.beside.front())}));
  return all;
}

Json map_schema(const yaml::Key& map) {
  Json properties = Json::object();
  std::vector<std::string> needed;
  for (const yaml::Key& key : map.of) {
    properties.set(key.name, key_schema(key));
    if (key.required) needed.push_back(key.name);
  }
  Json schema = typed("object").set("properties", std::move(properties));
  if (!needed.empty()) schema.set("required", Json::list_of(needed));
  schema.set("additionalProperties", map.rest.empty() ? Json(false) : key_schema(map.rest.front()));
  if (const std::vector<Json> rules = rules_of(map); !rules.empty())
    schema.set("allOf", Json::list_of(rules));
  if (Json pairs = companions_of(map); pairs.text() != "null")
    schema.set("dependentRequired", std::move(pairs));
  return schema;
}

Json either_schema(const yaml::Key& key) {
  std::vector<Json> forms;
  for (const yaml::Key& form : key.of) forms.push_back(key_schema(form));
  return any_of(std::move(forms));
}

/// Returns the schemas of forms that do not depend on the key.
const std::map<yaml::Key::Form, Json>& fixed_schemas() {
  using Form = yaml::Key::Form;
  static const std::map<Form, Json> schemas{
      {Form::text, schema_ref("text")},
      {Form::truth, typed("boolean")},
      {Form::computed, schema_ref("expression")},
      {Form::expression, schema_ref("expression")},
      {Form::series, schema_ref("series")},
      {Form::source, schema_ref("source")},
      {Form::value, Json::object().set("type", Json::list({"number", "string", "boolean", "array"}))},
      {Form::nothing, typed("null")},
      {Form::tree, Json::object()}};
  return schemas;
}

Json form_schema(const yaml::Key& key) {
  using Form = yaml::Key::Form;
  switch (key.form) {
    case Form::string:
      return key.pattern.empty() ? typed("string") : typed("string").set("pattern", key.pattern);
    case Form::word:
      return word_schema(key);
    case Form::whole:
      return whole_schema(key);
    case Form::number:
      return number_schema(key);
    case Form::list:
      return list_schema(key);
    case Form::names:
      return names_schema(key);
    case Form::keys:
      return map_schema(key);
    case Form::either:
      return either_schema(key);
    case Form::section:
      return schema_ref(key.refers);
    default:
      return fixed_schemas().at(key.form);
  }
}

}  // namespace

Json key_schema(const yaml::Key& key) {
  Json schema = form_schema(key);
  if (!key.doc.empty()) schema.set("description", key.doc);
  const bool plain = key.form == yaml::Key::Form::truth || key.form == yaml::Key::Form::word ||
                     key.form == yaml::Key::Form::whole || key.form == yaml::Key::Form::text ||
                     (key.form == yaml::Key::Form::number && key.unit.empty());
  if (plain && !key.otherwise.empty()) schema.set("default", scalar(key.otherwise));
  return schema;
}

}  // namespace stepwire::reference
