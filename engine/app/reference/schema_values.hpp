#pragma once

#include <string>
#include <vector>

#include "engine/base/json/json.hpp"
#include "engine/model/block/block_type.hpp"

namespace stepwire::reference {

/// Returns a reference to a definition: {"$ref": "#/$defs/time"}.
json::Json schema_ref(const std::string& definition);

/// Returns the schema of a JSON type: "string", "integer", "boolean", ...
json::Json typed(const std::string& type);

/// Returns a schema that accepts values of any of the given ones.
json::Json any_of(std::vector<json::Json> schemas);

/// Returns the schema of a list with elements of the schema `items`.
json::Json list_of(json::Json items);
/// Returns the schema of an element or a list of such elements.
json::Json one_or_list_of(const json::Json& item);

/// Returns the schema of a map with these keys and no others.
json::Json closed_map(json::Json properties, const std::vector<std::string>& required = {});

/// Adds an explanation, which editors show.
json::Json explained(json::Json schema, const std::string& doc);

/// Returns the schema of a constant word. Editors offer it with its explanation.
json::Json constant(const std::string& word, const std::string& doc);

/// Returns the schema of a number within a range: with a unit, or bare in SI.
json::Json number_in(const Range& range, const char* type = "number");

/// Returns the schema of a parameter's value.
json::Json parameter_schema(const BlockType& type, const ParameterSpec& spec);

/// Adds the definitions of values that the whole schema uses: number, time, text, source, ...
void add_value_definitions(json::Json& definitions);

}  // namespace stepwire::reference
