#pragma once

#include <string>

#include "engine/base/yaml/document.hpp"

namespace stepwire::yaml {

/// Writes a tree as YAML that parses to the same tree, except for locations. Short values are in flow style
/// on one line, others in block style. Texts are quoted where necessary.
std::string yaml_text(const Node& root);

/// Writes a tree in flow style on one line: `[1, 2]`.
std::string yaml_line(const Node& root);

}  // namespace stepwire::yaml
