#pragma once

#include <string>
#include <vector>

#include "engine/app/reference/block_reference.hpp"
#include "engine/base/yaml/key.hpp"

namespace stepwire::reference {

/// What stands behind a key, in words: "number", "list of texts", "one of none, huber, cauchy".
std::string form_text(const yaml::Key& key);
/// "above 0", "1 to 100"; empty where there is no limit.
std::string range_text(const yaml::Key& key);

/// The keys of a form, and those of the maps inside of it, each as a table.
std::vector<ReferenceTable> key_tables(const yaml::Key& form);

}  // namespace stepwire::reference
