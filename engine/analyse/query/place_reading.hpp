#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/query/formula.hpp"

namespace stepwire::query {

inline constexpr unit::Dimension length_dimension{{1.0}};
inline constexpr std::size_t max_coordinates = 3;  ///< of a place

/// Reads an expression that is a length: metres, or a bare number, which are metres.
std::optional<Formula> read_length(const yaml::Node& node, const SymbolTable& names,
                                   const std::string& subject, yaml::Faults& faults);

/// Reads a place of one to three coordinates: [x, y], or the name of a recorded vector (rig.position). Empty
/// and with a fault where it is none.
std::vector<Formula> read_place(const yaml::Node& node, const SymbolTable& names, const std::string& subject,
                                yaml::Faults& faults);

}  // namespace stepwire::query
