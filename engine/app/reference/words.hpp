#pragma once

#include <string>

#include "engine/model/block/block_type.hpp"

namespace stepwire::reference {

/// Converts a type name to a name in files: "MRDamper" to "mr_damper", "LookupTable2D" to "lookup_table_2d".
std::string snake_case(const std::string& name);

std::string first_sentence(const std::string& text);

/// Describes a kind of parameter: "number", "list of numbers", ...
std::string kind_text(ParameterKind kind);

/// Returns the unit written after a parameter's number, "mm"; empty if the parameter has no fixed unit.
std::string fixed_unit(const std::string& declared);

/// Formats a parameter value as in a diagram file: "0.5 s", "[1, 2]", "linear". An absent bound is "none".
std::string value_text(const ParameterSpec& spec, const Value& value);

/// Returns the default value of a parameter.
Value default_of(const BlockType& type, const ParameterSpec& spec);

/// Returns "required", or the default as in a diagram file.
std::string default_text(const BlockType& type, const ParameterSpec& spec);

/// Describes the allowed values of a parameter: "above 0, at most 1", or its words.
std::string allowed_text(const ParameterSpec& spec);

/// Describes when a block runs.
std::string timing_text(Timing timing);

/// Describes which inputs affect the outputs at the same instant.
std::string feedthrough_text(const BlockType& type);

}  // namespace stepwire::reference
