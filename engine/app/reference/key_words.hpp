#pragma once

#include <string>
#include <vector>

#include "engine/app/reference/block_reference.hpp"
#include "engine/base/yaml/key.hpp"

namespace stepwire::reference {

/// Describes the value of a key: "number", "list of texts", "one of none, huber, cauchy".
std::string form_text(const yaml::Key& key);
/// Describes the range of a key: "above 0", "1 to 100"; empty if unlimited.
std::string range_text(const yaml::Key& key);

/// Returns the keys of a form and of the maps inside it, one table for each map.
std::vector<ReferenceTable> key_tables(const yaml::Key& form);

}  // namespace stepwire::reference
