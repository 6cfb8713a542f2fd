#pragma once

#include <string>

#include "engine/base/yaml/document.hpp"

namespace stepwire::diagram {

/// Is a file to be used in other files only? It does not say for how long it runs, or nothing feeds one of
/// its inputs.
bool is_part(const yaml::Node& root);

/// A diagram, in no file, that consists of one part, whose inputs are fed by zeros. `path` is the part's
/// file.
yaml::Document user_of_part(const std::string& path, const yaml::Node& part);

}  // namespace stepwire::diagram
