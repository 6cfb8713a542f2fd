#pragma once

#include <optional>
#include <string>

#include "engine/base/unit/unit.hpp"
#include "engine/base/yaml/document.hpp"
#include "engine/model/block/spec.hpp"
#include "engine/model/diagram/element_units.hpp"
#include "engine/model/diagram/every.hpp"

namespace stepwire::diagram {

/// Makes a node of a text, taken literally, or of a name.
yaml::Node written_text(std::string text);
/// Makes a node of a text in which the reader replaces `$name`.
yaml::Node written_filled_in(const std::string& text);
/// Makes a node of a signal's name where a number is allowed as well.
yaml::Node written_signal(std::string name);
/// Makes a node of numbers in SI, in the shortest digits that read back to the same bits. The unit is added
/// if there is a dimension: `5`, `5 N`, `[1, 2]`, `{value: [1, 2], unit: N}`. A number repeated for all
/// elements is written once. A matrix in column-major order is a list of rows.
yaml::Node written_numbers(const Eigen::VectorXd& numbers, const std::optional<unit::Dimension>& dimension,
                           Eigen::Index columns = 1);
/// Makes a node of numbers in several units: `[0.001 m, 0.5 rad]`.
yaml::Node written_each(const Eigen::VectorXd& numbers, const EachUnit& each, Eigen::Index columns = 1);
/// Makes a node of a parameter's value. Returns std::nullopt for values that a file cannot express and only
/// defaults have: non-finite numbers and empty lists of numbers.
std::optional<yaml::Node> written_value(const ParameterSpec& spec, const Value& value,
                                        const std::optional<unit::Dimension>& dimension);
/// Makes a node of a period and its offset, if any; `time` is the dimension of times if units are written.
yaml::Node written_every(const Every& every, const std::optional<unit::Dimension>& time);
/// Adds a key to a map.
void add_key(yaml::Node& map, std::string key, yaml::Node value);

}  // namespace stepwire::diagram
