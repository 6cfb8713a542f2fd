#pragma once

#include <string>
#include <string_view>

#include "engine/base/yaml/document.hpp"

namespace stepwire::yaml {

/// Parses one YAML document from valid UTF-8 text into a tree. Throws Error with all faults.
Node read_yaml(std::string_view text, const std::string& file, const DocumentLimits& limits);

}  // namespace stepwire::yaml
