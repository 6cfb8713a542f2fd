#pragma once

#include <string>

#include "engine/base/yaml/document.hpp"

namespace stepwire::diagram {

/// True for a file that can only be used as a part: it has no stop time, or an input without a source.
bool is_part(const yaml::Node& root);

/// True for a map without any key of a diagram file, such as a file of tolerances.
bool is_other_map(const yaml::Node& root);

/// Returns the document of a diagram that consists of one part with zeros at its inputs. `path` is the part's
/// file.
yaml::Document user_of_part(const std::string& path, const yaml::Node& part);

}  // namespace stepwire::diagram
