#pragma once

#include <string>
#include <vector>

#include "engine/base/json/json.hpp"
#include "engine/model/block/block_type.hpp"

namespace stepwire::reference {

/// The definition of this name: {"$ref": "#/$defs/time"}.
json::Json schema_ref(const std::string& definition);

/// A value of this type of JSON: "string", "integer", "boolean", ...
json::Json typed(const std::string& type);

/// A schema that one of several must fit.
json::Json any_of(std::vector<json::Json> schemas);

/// One of these words.
json::Json one_word_of(const std::vector<std::string>& words);

/// A list of what fits `items`.
json::Json list_of(json::Json items);
/// What fits `item`, or a list of it.
json::Json one_or_list_of(const json::Json& item);

/// A map of these keys and no others.
json::Json closed_map(json::Json properties, const std::vector<std::string>& required = {});

/// The same with a text that an editor shows.
json::Json explained(json::Json schema, const std::string& doc);

/// A constant word with its explanation: an editor offers it with the text beside it.
json::Json constant(const std::string& word, const std::string& doc);

/// A number within a range, with a unit or a bare one in SI.
json::Json number_in(const Range& range, const char* type = "number");

/// What a file may give to a parameter.
json::Json parameter_schema(const BlockType& type, const ParameterSpec& spec);

/// Adds the values that all parts of the schema use: number, time, text, source, ...
void add_value_definitions(json::Json& definitions);

}  // namespace stepwire::reference
