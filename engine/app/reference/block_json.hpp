#pragma once

#include "engine/base/json/json.hpp"
#include "engine/model/block/registry.hpp"

namespace stepwire::reference {

/// A value of a parameter in JSON: numbers in SI, words as words; what is not finite is null.
json::Json value_json(const ParameterSpec& spec, const Value& value);

/// All that is declared of a block. Numbers are SI, `unit` is the declared one.
json::Json block_json(const BlockType& type);

/// The list of all blocks.
json::Json blocks_json(const Registry& registry);

}  // namespace stepwire::reference
