#pragma once

#include <string>

#include "engine/model/block/value.hpp"
#include "tests/blocks/contract_rig.hpp"

namespace stepwire {

/// A value of numbers as YAML.
std::string yaml_of(const Value& value);

/// Adds a file parameter p_NAME for every numeric parameter of the tested block. Returns an empty text if it
/// has none, or if the wiring is refused.
std::string with_parameters(const Wiring& wiring);

/// The same with the values that the block has in another wiring, where its signals may have other sizes.
std::string with_parameters(const Wiring& wiring, const Wiring& values);

/// The value with its numbers a little, or much, different.
Value changed(Value value, double factor, double more, bool whole);

}  // namespace stepwire
