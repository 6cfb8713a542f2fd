#pragma once

#include <string>
#include <vector>

#include "engine/base/json/json.hpp"
#include "engine/model/block/block_type.hpp"

namespace stepwire {

/// The definition of this name: {"$ref": "#/$defs/time"}.
Json schema_ref(const std::string& definition);

/// A value of this type of JSON: "string", "integer", "boolean", ...
Json typed(const std::string& type);

/// A schema that one of several must fit.
Json any_of(std::vector<Json> schemas);

/// One of these words.
Json one_word_of(const std::vector<std::string>& words);

/// A list of what fits `items`.
Json list_of(Json items);
/// What fits `item`, or a list of it.
Json one_or_list_of(const Json& item);

/// A map of these keys and no others.
Json closed_map(Json properties, const std::vector<std::string>& required = {});

/// The same with a text that an editor shows.
Json explained(Json schema, const std::string& doc);

/// A constant word with its explanation: an editor offers it with the text beside it.
Json constant(const std::string& word, const std::string& doc);

/// A number within a range, with a unit or a bare one in SI.
Json number_in(const Range& range, const char* type = "number");

/// What a file may give to a parameter.
Json parameter_schema(const BlockType& type, const ParameterSpec& spec);

/// Adds the values that all parts of the schema use: number, time, text, source, ...
void add_value_definitions(Json& definitions);

}  // namespace stepwire
