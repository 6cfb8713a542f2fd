#pragma once

#include <string>

#include "engine/model/block/value.hpp"
#include "tests/blocks/contract_rig.hpp"

namespace stepwire {

/// A value of numbers as YAML.
std::string yaml_of(const Value& value);

/// The wiring with a parameter of the file, p_NAME, for every number that the tested block is given; empty
/// where there is none.
std::string with_parameters(const Wiring& wiring);

/// The same with the values that the block has in another wiring, where its signals may have other sizes.
std::string with_parameters(const Wiring& wiring, const Wiring& values);

/// The value with its numbers a little, or much, different.
Value changed(Value value, double factor, double more, bool whole);

}  // namespace stepwire
