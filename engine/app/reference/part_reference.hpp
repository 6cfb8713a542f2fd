#pragma once

#include <string>
#include <vector>

#include "engine/app/reference/block_reference.hpp"
#include "engine/base/yaml/document.hpp"

namespace stepwire::reference {

/// What the page of a part says: its title and the comment below it, inputs, outputs and parameters as its
/// file declares them. `text` is that of the file.
BlockReference part_reference(const yaml::Document& document, const std::string& text);

/// The names of diagram files with their titles, a line each.
std::string part_list(const std::vector<yaml::Document>& documents);

}  // namespace stepwire::reference
