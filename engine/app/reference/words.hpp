#pragma once

#include <string>

#include "engine/model/block/block_type.hpp"

namespace stepwire::reference {

/// "MRDamper" as a name in files: "mr_damper"; "LookupTable2D" is "lookup_table_2d".
std::string snake_case(const std::string& name);

/// The first sentence of a text.
std::string first_sentence(const std::string& text);

/// What kind of value a parameter takes: "number", "list of numbers", ...
std::string kind_text(ParameterKind kind);

/// The unit behind a number of this parameter: "mm"; empty where it has none of its own.
std::string fixed_unit(const std::string& declared);

/// A value of a parameter as a diagram file writes it: "0.5 s", "[1, 2]", "linear"; "none" for a bound that
/// is absent.
std::string value_text(const ParameterSpec& spec, const Value& value);

/// The value that a parameter has unless the file gives one.
Value default_of(const BlockType& type, const ParameterSpec& spec);

/// "required", or the default as a file writes it.
std::string default_text(const BlockType& type, const ParameterSpec& spec);

/// What a parameter may be: "above 0, at most 1", or its words.
std::string allowed_text(const ParameterSpec& spec);

/// When a block runs.
std::string timing_text(Timing timing);

/// Which inputs the outputs depend on at the same instant.
std::string feedthrough_text(const BlockType& type);

}  // namespace stepwire::reference
