#pragma once

#include <string>

#include "engine/base/yaml/document.hpp"

namespace stepwire::yaml {

/// A tree as YAML that reads back to the same tree, places aside: what is short stands on one line in
/// brackets, the rest on lines of its own. A text without quotes gets them where it cannot stand without.
std::string yaml_text(const Node& root);

/// The same on one line, in brackets: `[1, 2]`.
std::string yaml_line(const Node& root);

}  // namespace stepwire::yaml
