#pragma once

#include <string>
#include <string_view>

#include "engine/base/yaml/document.hpp"

namespace stepwire::yaml {

/// Reads one YAML document out of sound UTF-8 text into a tree; throws Error for all that is wrong with it.
Node read_yaml(std::string_view text, const std::string& file, const DocumentLimits& limits);

}  // namespace stepwire::yaml
