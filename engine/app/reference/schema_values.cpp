#include "engine/app/reference/schema_values.hpp"

#include <fmt/format.h>

#include "engine/app/reference/block_json.hpp"
#include "engine/app/reference/words.hpp"

namespace stepwire::reference {

using json::Json;

namespace {

Json patterned(const char* pattern) {
  return typed("string").set("pattern", pattern);
}

/// Returns the schema of a word that a parameter of the file gives: `$law`.
Json parameter_word() {
  return patterned("\\$");
}

/// Returns the schema of a bare number in SI, with its bounds. Quantities with units are text in the schema
/// and are checked on loading.
Json bounded_number(const Range& range, const char* type = "number") {
  Json number = typed(type);
  if (range.above) number.set("exclusiveMinimum", *range.above);
  if (range.at_least) number.set("minimum", *range.at_least);
  if (range.below) number.set("exclusiveMaximum", *range.below);
  if (range.at_most) number.set("maximum", *range.at_most);
  return number;
}

Json element_with(const Range& range) {
  return any_of({bounded_number(range), schema_ref("quantity")});
}

enum class Rows { none, some, all };

/// Returns the schema of lists of numbers: vectors, matrices, or both.
Json lists_of(const Json& element, Rows rows) {
  const Json row = list_of(element);
  if (rows == Rows::none) return row;
  return list_of(rows == Rows::all ? row : any_of({element, row}));
}

Json list_with(const Range& range, Rows rows) {
  return any_of({bounded_number(range), schema_ref("quantity"), schema_ref("value_with_unit"),
                 lists_of(element_with(range), rows)});
}

/// Returns the schema of an enumeration.
Json one_word_of(const std::vector<std::string>& words) {
  return Json::object().set("enum", Json::list_of(words));
}

Json kind_schema(const BlockType& type, const ParameterSpec& spec) {
  switch (spec.kind) {
    case ParameterKind::number:
      return number_in(spec.range);
    case ParameterKind::integer:
      return number_in(spec.range, "integer");
    case ParameterKind::flag:
      return any_of({typed("boolean"), parameter_word()});
    case ParameterKind::word:
      return any_of({one_word_of(spec.words), parameter_word()});
    case ParameterKind::text:
      return schema_ref("text");
    case ParameterKind::file:
      return typed("string");
    case ParameterKind::per_element:
      return list_with(spec.range, type.inputs.empty() ? Rows::some : Rows::none);
    case ParameterKind::vector:
      return list_with(spec.range, Rows::none);
    case ParameterKind::matrix:
      return list_with(spec.range, Rows::all);
    case ParameterKind::texts:
      return any_of({schema_ref("text"), list_of(schema_ref("text"))});
    case ParameterKind::tree:
      return any_of({typed("object"), typed("array")});
  }
  return Json::object();
}

std::string explanation(const BlockType& type, const ParameterSpec& spec) {
  std::string text = spec.doc;
  if (const std::string unit = fixed_unit(spec.unit); !unit.empty()) text += fmt::format(" [{}]", unit);
  if (const std::string allowed = allowed_text(spec); !allowed.empty()) text += "; " + allowed;
  return text + (spec.required ? "; required" : "; default " + default_text(type, spec));
}

/// True if the default can be written in a file as it is, so that editors can offer it.
bool is_simple(const ParameterSpec& spec, const std::string& text) {
  const bool plain = spec.kind == ParameterKind::number || spec.kind == ParameterKind::integer ||
                     spec.kind == ParameterKind::flag || spec.kind == ParameterKind::word ||
                     spec.kind == ParameterKind::per_element;
  return !spec.required && plain && text.find("none") == std::string::npos && text[0] != '[';
}

Json value_with_unit() {
  return closed_map(Json::object()
                        .set("value", any_of({typed("number"), schema_ref("quantity"), typed("array")}))
                        .set("unit", explained(schema_ref("text"), "unit of all numbers: N/mm")),
                    {"value"});
}

}  // namespace

Json number_in(const Range& range, const char* type) {
  return any_of({bounded_number(range, type), schema_ref("quantity"), schema_ref("value_with_unit")});
}

Json schema_ref(const std::string& definition) {
  return Json::object().set("$ref", "#/$defs/" + definition);
}

Json typed(const std::string& type) {
  return Json::object().set("type", type);
}

Json any_of(std::vector<Json> schemas) {
  return Json::object().set("anyOf", Json::list(std::move(schemas)));
}

Json list_of(Json items) {
  return typed("array").set("items", std::move(items));
}

Json one_or_list_of(const Json& item) {
  return any_of({item, list_of(item).set("minItems", 1)});
}

Json closed_map(Json properties, const std::vector<std::string>& required) {
  Json map = typed("object").set("properties", std::move(properties));
  if (!required.empty()) map.set("required", Json::list_of(required));
  return map.set("additionalProperties", false);
}

Json explained(Json schema, const std::string& doc) {
  return schema.set("description", doc);
}

Json constant(const std::string& word, const std::string& doc) {
  return explained(Json::object().set("const", word), doc);
}

Json parameter_schema(const BlockType& type, const ParameterSpec& spec) {
  Json schema = explained(kind_schema(type, spec), explanation(type, spec));
  const Value value = default_of(type, spec);
  const std::string text = value_text(spec, value);
  if (!is_simple(spec, text)) return schema;
  const bool with_unit = !fixed_unit(spec.unit).empty() && spec.kind != ParameterKind::word;
  return schema.set("default", with_unit ? Json(text) : value_json(spec, value));
}

void add_value_definitions(Json& definitions) {
  Range above_zero;
  above_zero.above = 0.0;
  definitions.set("text", Json::object().set("type", Json::list({"string", "number", "boolean"})));
  definitions.set(
      "expression",
      explained(
          schema_ref("text"),
          "an expression over recorded columns: abs(rig.x) > 2 mm; quoted where it has , [ { or a colon"));
  definitions.set(
      "quantity",
      explained(patterned("\\S"),
                "a number with a unit (5 mm), a parameter (tau) or an expression of parameters (2*pi*f)"));
  definitions.set("value_with_unit", value_with_unit());
  definitions.set("number", number_in({}));
  definitions.set("time",
                  explained(number_in(above_zero), "a time above 0, in s unless a unit is given: 1 ms"));
  definitions.set("numbers", list_with({}, Rows::some));
  definitions.set("source",
                  explained(any_of({schema_ref("text"), lists_of(element_with({}), Rows::some),
                                    schema_ref("value_with_unit")}),
                            "a block (lag), its output (rig.x), an input of this part, or a number (5 mm)"));
  definitions.set("file", explained(typed("string"), "a path beside this file"));
}

}  // namespace stepwire::reference
