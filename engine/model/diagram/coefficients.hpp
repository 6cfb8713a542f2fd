#pragma once

#include <optional>
#include <string>

#include "engine/model/diagram/parameters.hpp"

namespace stepwire::diagram {

/// True for a list of coefficients, highest power first. Each has the unit of the next one times the unit
/// after "by": "'n by s".
bool are_coefficients(const ParameterSpec& spec);

/// Reads coefficients, each with an optional unit; the dimension is that of the last one. Adds a fault and
/// returns std::nullopt where a unit does not fit its power.
std::optional<WrittenValue> read_coefficients(const ValueReader& reader, FaultReport& report,
                                              const ParameterSpec& spec, const yaml::Node& list,
                                              const std::string& subject);

}  // namespace stepwire::diagram
