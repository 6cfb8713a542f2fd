#pragma once

#include <optional>
#include <string>

#include "engine/base/unit/unit.hpp"
#include "engine/base/yaml/document.hpp"
#include "engine/model/block/spec.hpp"
#include "engine/model/diagram/every.hpp"

namespace stepwire::diagram {

/// A text as it stands, or a name.
yaml::Node written_text(std::string text);
/// A text in which a file's reader looks for `$name`.
yaml::Node written_filled_in(const std::string& text);
/// The name of a signal where a number could stand as well.
yaml::Node written_signal(std::string name);
/// Numbers in SI, in the shortest digits that read back to the same bits, with the name of the unit where
/// there is a dimension: `5`, `5 N`, `[1, 2]`, `{value: [1, 2], unit: N}`. One number of several elements
/// stands alone; a matrix, whose numbers are column by column, is a list of rows.
yaml::Node written_numbers(const Eigen::VectorXd& numbers, const std::optional<unit::Dimension>& dimension,
                           Eigen::Index columns = 1);
/// The value of a parameter as a file gives it; nothing for what no file can give, which only defaults are:
/// numbers that are not finite, and lists of numbers that are empty.
std::optional<yaml::Node> written_value(const ParameterSpec& spec, const Value& value,
                                        const std::optional<unit::Dimension>& dimension);
/// A period, with its offset where it has one; `time` is the dimension of times, where units are written.
yaml::Node written_every(const Every& every, const std::optional<unit::Dimension>& time);
/// Adds a key to a map.
void add_key(yaml::Node& map, std::string key, yaml::Node value);

}  // namespace stepwire::diagram
