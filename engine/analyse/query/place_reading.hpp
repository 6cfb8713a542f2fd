#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/query/formula.hpp"

namespace stepwire::query {

inline constexpr unit::Dimension length_dimension{{1.0}};
inline constexpr std::size_t max_coordinates = 3;  ///< of one place

/// Reads an expression for a length. A bare number is in metres.
std::optional<Formula> read_length(const yaml::Node& node, const SymbolTable& names,
                                   const std::string& subject, yaml::Faults& faults);

/// Reads a place of one to three coordinates: [x, y], or the name of a recorded vector (rig.position). Adds a
/// fault and returns an empty list for anything else.
std::vector<Formula> read_place(const yaml::Node& node, const SymbolTable& names, const std::string& subject,
                                yaml::Faults& faults);

}  // namespace stepwire::query
