#pragma once

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "engine/app/simulink/value.hpp"
#include "engine/base/yaml/document.hpp"

namespace stepwire::simulink {

/// Makes a node of a text.
yaml::Node word(std::string text);
/// Makes a node of a text in quotes.
yaml::Node quoted(std::string text);
yaml::Node list_of(std::vector<yaml::Node> items);
yaml::Node map_of(std::vector<std::pair<std::string, yaml::Node>> entries);
void add(yaml::Node& map, std::string key, yaml::Node value);

/// Makes a node of a number or formula: `5`, `$K`, `= 2*K`.
yaml::Node cell_node(const Cell& cell);
/// Makes a node of a number, of a list of a vector's elements, or of a list of rows.
yaml::Node value_node(const Value& value);
/// Makes a list of the elements, also of a single one.
yaml::Node list_node(const Value& value);
/// Makes a list of rows, also of a vector.
yaml::Node rows_node(const Value& value);

}  // namespace stepwire::simulink
