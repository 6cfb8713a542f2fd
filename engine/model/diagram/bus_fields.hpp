#pragma once

#include <string>
#include <vector>

#include "engine/model/diagram/scope.hpp"

namespace stepwire::diagram {

/// Returns the fields of a bus in a file, {force: f, pose: {position: p}} or {fields: {..}}. A field is a
/// signal, a number, a list of numbers, {signal: f, unit: N, shape: 3}, or the map of a nested bus.
BusFields written_fields(const yaml::Node& map);
/// Returns the fields that a port declares: {force: N, pose: {position: {unit: m, shape: 3}}}.
BusFields declared_fields(const yaml::Node& map);
/// Parses "3" or "3 x 2" as rows and columns.
std::optional<std::pair<Eigen::Index, Eigen::Index>> parse_shape(const std::string& text);
/// Returns the remainders of the names that begin with `start` and a dot.
std::vector<std::string> names_below(const std::vector<std::string>& names, const std::string& start);

}  // namespace stepwire::diagram
