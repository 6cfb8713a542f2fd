#pragma once

#include <string>
#include <vector>

#include "engine/base/yaml/key.hpp"

namespace stepwire::yaml {

/// Returns the groups of which a key is one choice: "reduction", or both of "reduction and comparison".
std::vector<std::string> choice_groups(const Key& key);

}  // namespace stepwire::yaml
