#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "engine/base/yaml/document.hpp"

namespace stepwire {

/// Converts a YAML value to JSON. Distinguishes numbers and flags from text as YAML 1.2 does.
nlohmann::json json_of(const yaml::Node& node);

/// Returns the faults of a value by a JSON schema, one line each; empty if it is valid. Supports the part of
/// draft 2020-12 that the schema of diagram files uses, and throws std::logic_error for any other keyword.
std::string schema_faults(const nlohmann::json& value, const nlohmann::json& schema);

}  // namespace stepwire
