#include "engine/base/result/result_type.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace stepwire::result {

using Kind = ValueType::Kind;

namespace {

/// Words of one language for each kind of values, in the order of Kind. The words of a list and of a map have
/// a place for those of their items, `none` for those of the value.
struct Language {
  std::array<const char*, 12> words;
  const char* none;
};

constexpr Language english{{"flag", "count", "number", "number", "text", "[re, im]", "[low, high]",
                            "list of rows", "list of {}", "{} by name", "", "JSON"},
                           "{} or null"};
// JSON has no number for what is not finite.
constexpr Language typescript{
    {"boolean", "number", "number", "number | null", "string", "[number, number]",
     "[number | null, number | null]", "(number | null)[][]", "({})[]", "Record<string, {}>", "", "unknown"},
    "{} | null"};
// In Python a missing number is nan and a missing text is empty.
constexpr Language python{{"bool", "int", "float", "float", "str", "complex", "tuple[float, float]",
                           "list[list[float]]", "list[{}]", "dict[str, {}]", "", "Any"},
                          "Optional[{}]"};

/// True if the words of a type already include those for a missing value.
bool has_none(const ValueType& type, const Language& in) {
  const bool is_text = type.kind == Kind::text, is_number = type.kind == Kind::number;
  if (type.kind == Kind::any) return true;
  if (&in == &python) return is_text || is_number || type.kind == Kind::list || type.kind == Kind::map;
  return &in == &typescript && is_number;
}

std::string words_of(const ValueType& type, const Language& in) {
  std::string words = in.words[static_cast<std::size_t>(type.kind)];
  if (type.record) words = type.record().name;
  if (!type.item.empty()) words = fmt::format(fmt::runtime(words), words_of(type.item[0], in));
  const bool is_simple = words.starts_with("(") && words.find('|') == std::string::npos;
  if (is_simple && words.ends_with(")[]")) words = words.substr(1, words.size() - 4) + "[]";
  return type.optional && !has_none(type, in) ? fmt::format(fmt::runtime(in.none), words) : words;
}

void add_record(const RecordType& record, std::vector<const RecordType*>& all) {
  if (std::ranges::find(all, &record) != all.end()) return;
  for (const FieldType& field : record.fields) {
    const ValueType* type = &field.type;
    while (!type->item.empty()) type = &type->item[0];
    if (type->record) add_record(type->record(), all);
  }
  all.push_back(&record);
}

bool is_name(const std::string& text) {
  return std::ranges::all_of(text, [](unsigned char c) { return std::isalnum(c) || c == '_'; });
}

json::Json type_json(const ValueType& type) {
  static const char* const kinds[] = {"flag", "count",  "number", "number", "text",   "complex",
                                      "pair", "matrix", "list",   "map",    "record", "any"};
  json::Json json = json::Json::object().set("kind", kinds[static_cast<std::size_t>(type.kind)]);
  if (type.record) json.set("record", type.record().name);
  if (!type.item.empty()) json.set("item", type_json(type.item[0]));
  return json;
}

std::string doc_of(const FieldType& field) {
  return field.doc + (field.unit.empty() ? "" : " [" + field.unit + "]");
}

std::string member_text(const FieldType& field) {
  const std::string name = is_name(field.name) ? field.name : '"' + field.name + '"';
  ValueType type = field.type;
  if (field.omitted) type.optional = false;
  const std::string words = field.choices.empty()
                                ? words_of(type, typescript)
                                : fmt::format("\"{}\"", fmt::join(field.choices, "\" | \""));
  return fmt::format("  /** {} */\n  {}{}: {};\n", doc_of(field), name, field.omitted ? "?" : "", words);
}

}  // namespace

json::Json RecordType::json_of(const void* object, bool hidden) const {
  json::Json json = json::Json::object();
  for (const FieldType& field : fields) {
    if (field.hidden && !hidden) continue;
    json::Json value = field.value(object);
    if (!field.omitted || !value.is_null()) json.set(field.name, std::move(value));
  }
  return json;
}

std::string type_text(const ValueType& type) {
  return words_of(type, english);
}

std::vector<const RecordType*> records_of(const std::vector<const RecordType*>& roots) {
  std::vector<const RecordType*> all;
  for (const RecordType* root : roots) add_record(*root, all);
  return all;
}

json::Json description_of(const std::vector<const RecordType*>& roots) {
  json::Json list = json::Json::list();
  for (const RecordType* record : records_of(roots)) {
    json::Json fields = json::Json::list();
    for (const FieldType& field : record->fields)
      fields.push(json::Json::object()
                      .set("name", field.name)
                      .set("attribute", attribute_of(field.name))
                      .set("doc", field.doc)
                      .set("unit", field.unit)
                      .set("type", type_json(field.type)));
    list.push(json::Json::object()
                  .set("name", record->name)
                  .set("doc", record->doc)
                  .set("fields", std::move(fields)));
  }
  return list;
}

std::string typescript_of(const std::vector<const RecordType*>& roots) {
  std::string text;
  for (const RecordType* record : records_of(roots)) {
    text += fmt::format("\n/** {} */\nexport interface {} {{\n", record->doc, record->name);
    for (const FieldType& field : record->fields)
      if (!field.hidden) text += member_text(field);
    text += "}\n";
  }
  return text;
}

std::string python_stub_of(const std::vector<const RecordType*>& roots) {
  std::string text;
  for (const RecordType* record : records_of(roots)) {
    text += fmt::format("\nclass {}(Record):\n    \"\"\"{}\"\"\"\n", record->name, record->doc);
    for (const FieldType& field : record->fields) {
      ValueType type = field.type;
      if (field.omitted && type.kind == Kind::flag) type.optional = false;
      text += fmt::format("    {}: {}\n    \"\"\"{}\"\"\"\n", attribute_of(field.name),
                          words_of(type, python), doc_of(field));
    }
  }
  return text;
}

std::string attribute_of(const std::string& field) {
  std::string name = field;
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
}

}  // namespace stepwire::result
