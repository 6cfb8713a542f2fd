#pragma once

#include "engine/base/json/json.hpp"
#include "engine/model/block/registry.hpp"

namespace stepwire::reference {

/// Converts a parameter value to JSON: numbers in SI, words as text, null for non-finite numbers.
json::Json value_json(const ParameterSpec& spec, const Value& value);

/// Returns the whole declaration of a block. Numbers are SI; `unit` is the declared one.
json::Json block_json(const BlockType& type);

json::Json blocks_json(const Registry& registry);

}  // namespace stepwire::reference
