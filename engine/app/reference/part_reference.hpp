#pragma once

#include <string>
#include <vector>

#include "engine/app/reference/block_reference.hpp"
#include "engine/base/yaml/document.hpp"

namespace stepwire::reference {

/// Returns the page of a part: its title and the comment below it, and its declared inputs, outputs and
/// parameters. `text` is the text of the file.
BlockReference part_reference(const yaml::Document& document, const std::string& text);

/// Returns the names of diagram files with their titles, one line each.
std::string part_list(const std::vector<yaml::Document>& documents);

}  // namespace stepwire::reference
